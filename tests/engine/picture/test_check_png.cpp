// PNG files that are built wrongly, one mistake at a time.
#include <doctest.h>
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG  // the programs have no PNG decoder of stb_image
#include <stb_image.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "dice.hpp"
#include "engine/picture/codecs/checksums.hpp"
#include "engine/picture/decode_image.hpp"
#include "engine/system/file_error.hpp"

namespace {

using File = std::vector<std::uint8_t>;
using texmap::Image;
using texmap::Rgb8;

File joined(std::initializer_list<File> parts) {
  File all;
  for (const File& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

File big_endian(std::size_t number) {
  File bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes.push_back(static_cast<std::uint8_t>(number >> shift & 0xFFU));
  return bytes;
}

File chunk(const std::string& type, const File& data) {
  const File named = joined({File(type.begin(), type.end()), data});
  return joined({big_endian(data.size()), named, big_endian(texmap::crc32(named))});
}

File header(std::size_t width, std::size_t height, std::uint8_t depth, std::uint8_t color,
            std::uint8_t compression = 0, std::uint8_t filter = 0, std::uint8_t interlace = 0) {
  return chunk("IHDR", joined({big_endian(width),
                               big_endian(height),
                               {depth, color, compression, filter, interlace}}));
}

// The rows as a zlib stream of one stored block.
File stream(const File& rows) {
  const std::size_t size = rows.size();
  const auto low = static_cast<std::uint8_t>(size & 0xFFU);
  const auto high = static_cast<std::uint8_t>(size >> 8);
  const auto flipped = [](std::uint8_t byte) { return static_cast<std::uint8_t>(~byte & 0xFF); };
  return joined({{0x78, 0x01, 1, low, high, flipped(low), flipped(high)},
                 rows,
                 big_endian(texmap::adler32(rows))});
}

File pixels(const File& rows) { return chunk("IDAT", stream(rows)); }

const File start = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
const File end = chunk("IEND", {});
const File grey_header = header(2, 1, 8, 0);
const File grey_rows = {0, 10, 20};
const File two_colors = chunk("PLTE", {1, 2, 3, 4, 5, 6});
const File three_colors = chunk("PLTE", {1, 2, 3, 4, 5, 6, 7, 8, 9});

// "it loads", or what the error says.
std::string outcome(const File& file) {
  try {
    static_cast<void>(texmap::decode_image(file));
    return "it loads";
  } catch (const texmap::FileError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("the smallest PNG files there are load") {
  const Image grey = texmap::decode_image(joined({start, grey_header, pixels(grey_rows), end}));
  CHECK(grey.pixels == std::vector<Rgb8>{{10, 10, 10}, {20, 20, 20}});
  const Image palette = texmap::decode_image(
      joined({start, header(2, 1, 8, 3), two_colors, pixels({0, 1, 0}), end, {9, 9}}));
  CHECK(palette.pixels == std::vector<Rgb8>{{4, 5, 6}, {1, 2, 3}});
  const Image half = texmap::decode_image(
      joined({start, header(1, 1, 16, 2), pixels({0, 1, 255, 2, 255, 3, 255}), end}));
  CHECK(half.pixels == std::vector<Rgb8>{{1, 2, 3}});
}

TEST_CASE("a PNG file with one mistake is refused with its reason") {
  const File body = pixels(grey_rows);
  const File palette_header = header(2, 1, 8, 3);
  const File palette_pixels = pixels({0, 1, 0});
  const std::vector<std::pair<File, std::string>> table = {
      {start, "end marker"},
      {joined({start, body, grey_header, end}), "begin with its header"},
      {joined({start, chunk("IHDR", {0, 0}), body, end}), "13 bytes"},
      {joined({start, grey_header, grey_header, body, end}), "two headers"},
      {joined({start, header(0, 1, 8, 0), body, end}), "0 x 1 pixels"},
      {joined({start, header(16385, 1, 8, 0), body, end}), "a side may have at most 16384"},
      {joined({start, header(1, 16385, 8, 0), body, end}), "a side may have at most 16384"},
      {joined({start, header(16384, 8193, 8, 0), body, end}), "may make at most 134217728"},
      {joined({start, header(16384, 8192, 16, 6), body, end}), "MiB of memory"},
      {joined({start, header(16384, 8192, 16, 2, 0, 0, 1), body, end}), "MiB of memory"},
      {joined({start, header(8192, 8192, 8, 0), body, end}), "too few bytes"},
      {joined({start, header(2, 1, 3, 0), body, end}), "does not exist"},
      {joined({start, header(2, 1, 16, 3), body, end}), "does not exist"},
      {joined({start, header(2, 1, 4, 4), body, end}), "does not exist"},
      {joined({start, header(2, 1, 8, 7), body, end}), "does not exist"},
      {joined({start, header(2, 1, 8, 0, 1), body, end}), "method that does not exist"},
      {joined({start, header(2, 1, 8, 0, 0, 1), body, end}), "method that does not exist"},
      {joined({start, header(2, 1, 8, 0, 0, 0, 2), body, end}), "method that does not exist"},
      {joined({start, grey_header, end}), "it has no pixels"},
      {joined({start, grey_header, body}), "end marker"},
      {joined({start, grey_header, body, chunk("IEND", {0})}), "is not empty"},
      {joined({start, grey_header, body, chunk("tEXt", {}), chunk("IDAT", {}), end}),
       "not in one piece"},
      {joined({start, grey_header, chunk("CgBI", {}), body, end}), "does not know (chunk CgBI)"},
      {joined({start, grey_header, chunk("t xt", {}), body, end}), "no proper name"},
      // Palette and transparency.
      {joined({start, grey_header, two_colors, body, end}), "grey picture has a palette"},
      {joined({start, palette_header, palette_pixels, end}), "palette (PLTE) is missing"},
      {joined({start, palette_header, two_colors, two_colors, palette_pixels, end}),
       "two palettes"},
      {joined({start, palette_header, chunk("PLTE", {}), palette_pixels, end}), "1 to 256 colors"},
      {joined({start, palette_header, chunk("PLTE", {1, 2, 3, 4}), palette_pixels, end}),
       "1 to 256 colors"},
      {joined({start, header(2, 1, 1, 3), three_colors, pixels({0, 0}), end}), "1 to 2 colors"},
      {joined({start, header(1, 1, 8, 2), pixels({0, 1, 2, 3}), two_colors, end}),
       "after the pixels"},
      {joined({start, header(1, 1, 8, 2), chunk("tRNS", File(6)), two_colors, pixels({0, 1, 2, 3}),
               end}),
       "after the transparency"},
      {joined({start, palette_header, chunk("tRNS", {1}), two_colors, palette_pixels, end}),
       "before the palette"},
      {joined({start, palette_header, two_colors, chunk("tRNS", {1, 2, 3}), palette_pixels, end}),
       "instead of 2"},
      {joined({start, palette_header, two_colors, palette_pixels, chunk("tRNS", {1}), end}),
       "after the pixels"},
      {joined({start, grey_header, chunk("tRNS", {1}), body, end}), "instead of 2"},
      {joined({start, grey_header, chunk("tRNS", {0, 1}), chunk("tRNS", {0, 1}), body, end}),
       "two transparencies"},
      {joined({start, header(1, 1, 8, 4), chunk("tRNS", {0, 1}), pixels({0, 1, 2}), end}),
       "with an alpha channel"},
      {joined({start, palette_header, two_colors, pixels({0, 1, 2}), end}),
       "color 2 of a palette with 2"},
      // Pixels.
      {joined({start, grey_header, chunk("IDAT", {0x78, 0x01, 1}), end}), "too few bytes"},
      {joined({start, grey_header, pixels({0, 10}), end}), "end after 2 of 3 bytes"},
      {joined({start, grey_header, pixels({0, 10, 20, 30}), end}), "do not unpack"},
      {joined({start, grey_header, pixels({5, 10, 20}), end}), "filter 5"},
  };
  for (std::size_t i = 0; i < table.size(); ++i) {
    CAPTURE(i);
    const std::string said = outcome(table[i].first);
    INFO("said: ", said, ", expected: ", table[i].second);
    CHECK(said.find(table[i].second) != std::string::npos);
  }
  CHECK(table.size() == 43);
}

// Three rows of two palette indices; color 2 does not exist. In each file a filter makes the last
// index 1 or 2.
TEST_CASE("a palette index is looked at after the filter of its row is undone") {
  struct Case {
    std::uint8_t filter, good, bad;
  };
  for (const Case& one :
       {Case{0, 1, 2}, Case{1, 0, 1}, Case{2, 0, 1}, Case{3, 0, 1}, Case{4, 0, 1}}) {
    CAPTURE(one.filter);
    for (const bool good : {true, false}) {
      const std::uint8_t left = one.filter == 1 || one.filter == 3 ? 1 : 0;
      const std::uint8_t first = one.filter == 1 || one.filter == 0
                                     ? left
                                     : static_cast<std::uint8_t>(one.filter == 3 ? 1 : 0);
      const File rows = {0, 0, 1, one.filter, first, good ? one.good : one.bad};
      const std::string said =
          outcome(joined({start, header(2, 2, 8, 3), two_colors, pixels(rows), end}));
      if (good) CHECK(said == "it loads");
      if (!good) CHECK(said.find("color 2 of a palette with 2 colors") != std::string::npos);
    }
  }
}

TEST_CASE("random rows of every kind become the pixels that stb_image makes of them") {
  struct Kind {
    std::uint8_t color, depth;
    int channels;
  };
  const std::vector<std::array<int, 4>> whole = {{0, 0, 1, 1}};
  const std::vector<std::array<int, 4>> adam7 = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8},
                                                 {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2},
                                                 {0, 1, 1, 2}};  // column, row and their steps
  texmap::test::Dice dice;
  const auto noise = [&](int bytes) {
    File made(static_cast<std::size_t>(bytes));
    for (std::uint8_t& byte : made) byte = static_cast<std::uint8_t>(dice.bits());
    return made;
  };
  int compared = 0;
  for (const Kind& kind : {Kind{0, 1, 1},
                           {0, 2, 1},
                           {0, 4, 1},
                           {0, 8, 1},
                           {0, 16, 1},
                           {2, 8, 3},
                           {2, 16, 3},
                           {3, 1, 1},
                           {3, 2, 1},
                           {3, 4, 1},
                           {3, 8, 1},
                           {4, 8, 2},
                           {4, 16, 2},
                           {6, 8, 4},
                           {6, 16, 4}}) {
    for (const int width : {1, 2, 5, 64, 65}) {
      for (const bool interlaced : {false, true}) {
        CAPTURE(static_cast<int>(kind.color));
        CAPTURE(static_cast<int>(kind.depth));
        CAPTURE(width);
        CAPTURE(interlaced);
        const int height = 20;
        File rows;
        for (const auto& [column, row, column_step, row_step] : interlaced ? adam7 : whole) {
          const int columns = (width - column + column_step - 1) / column_step;
          for (int y = row; y < height && columns > 0; y += row_step) {
            rows.push_back(static_cast<std::uint8_t>(dice.below(5)));
            const File bytes = noise((columns * kind.channels * kind.depth + 7) / 8);
            rows.insert(rows.end(), bytes.begin(), bytes.end());
          }
        }
        const File palette = kind.color == 3 ? chunk("PLTE", noise(3 << kind.depth)) : File{};
        const File file = joined({start,
                                  header(static_cast<std::size_t>(width), height, kind.depth,
                                         kind.color, 0, 0, interlaced ? 1 : 0),
                                  palette, pixels(rows), end});
        int stb_width = 0;
        int stb_height = 0;
        int stb_channels = 0;
        const std::unique_ptr<stbi_uc, void (*)(void*)> stb(
            stbi_load_from_memory(file.data(), static_cast<int>(file.size()), &stb_width,
                                  &stb_height, &stb_channels, 3),
            stbi_image_free);
        REQUIRE(stb != nullptr);
        const Image image = texmap::decode_image(file);
        REQUIRE(image.width == stb_width);
        REQUIRE(image.height == stb_height);
        const bool same = std::equal(image.pixels.begin(), image.pixels.end(),
                                     reinterpret_cast<const Rgb8*>(stb.get()));
        CHECK(same);
        ++compared;
      }
    }
  }
  CHECK(compared == 150);
}

TEST_CASE("bits behind the last pixel of a row are no palette index") {
  CHECK(outcome(joined({start, header(1, 1, 2, 3), two_colors, pixels({0, 0x7F}), end})) ==
        "it loads");
  CHECK(outcome(joined({start, header(1, 1, 2, 3), two_colors, pixels({0, 0x80}), end})) !=
        "it loads");
}

namespace {

// A zlib stream of `count` zeros in deflate's fixed codes: one zero, runs of 258, then single ones.
File stream_of_zeros(std::size_t count) {
  File bytes = {0x78, 0x01};
  std::uint32_t buffer = 0;
  int bits = 0;
  const auto put = [&](std::uint32_t code, int length) {
    buffer |= code << bits;
    for (bits += length; bits >= 8; bits -= 8, buffer >>= 8)
      bytes.push_back(static_cast<std::uint8_t>(buffer & 0xFFU));
  };
  put(3, 3);     // the last block, with fixed codes
  put(0x0C, 8);  // 00110000 from its last bit on: a byte of 0
  std::size_t done = 1;
  for (; count - done >= 258; done += 258)
    put(0xA3, 13);  // 11000101 from its last bit on: 258 bytes, and 00000: from 1 before
  for (; done < count; ++done) put(0x0C, 8);
  put(0, 7 + 8);  // the end, and whole bytes
  const std::uint64_t modulus = 65521;
  const File sum = big_endian((count % modulus) << 16 | 1);  // Adler-32 of zeros
  bytes.insert(bytes.end(), sum.begin(), sum.end());
  return bytes;
}

}  // namespace

TEST_CASE("a picture of more than 64 MiB loads as well as one of less") {
  for (const std::size_t height : {std::size_t{3}, std::size_t{1366}}) {
    const std::size_t rows = height * (1 + 3 * 16384);
    const Image image = texmap::decode_image(
        joined({start, header(16384, height, 8, 2), chunk("IDAT", stream_of_zeros(rows)), end}));
    const bool same = image == Image(16384, static_cast<int>(height));
    CHECK(same);
  }
}

TEST_CASE("the largest picture loads") {
  const Image image =
      texmap::decode_image(joined({start, header(16384, 8192, 8, 2),
                                   chunk("IDAT", stream_of_zeros(8192 * (1 + 3 * 16384))), end}));
  CHECK(image.width == 16384);
  CHECK(image.height == 8192);
  CHECK(std::all_of(image.pixels.begin(), image.pixels.end(),
                    [](const Rgb8& pixel) { return pixel == Rgb8{}; }));
}

TEST_CASE("a stream that unpacks to more than it should is refused before it takes memory") {
  const File bomb = joined(
      {start, header(16, 16, 8, 2), chunk("IDAT", stream_of_zeros(std::size_t{1} << 30)), end});
  CHECK(outcome(bomb).find("do not unpack to the 784 bytes") != std::string::npos);
}
