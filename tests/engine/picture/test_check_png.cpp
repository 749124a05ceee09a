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

File png(std::initializer_list<File> chunks) { return joined({start, joined(chunks), end}); }

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
  const std::vector<std::pair<File, std::vector<Rgb8>>> table = {
      {png({grey_header, pixels(grey_rows)}), {{10, 10, 10}, {20, 20, 20}}},
      {joined({png({header(2, 1, 8, 3), two_colors, pixels({0, 1, 0})}), {9, 9}}),
       {{4, 5, 6}, {1, 2, 3}}},
      {png({header(1, 1, 16, 2), pixels({0, 1, 255, 2, 255, 3, 255})}), {{1, 2, 3}}},
      // Bits behind the last pixel of a row are no palette index.
      {png({header(1, 1, 2, 3), two_colors, pixels({0, 0x7F})}), {{4, 5, 6}}},
  };
  for (const auto& [file, expected] : table) CHECK(texmap::decode_image(file).pixels == expected);
}

TEST_CASE("a PNG file with one mistake is refused with its reason") {
  const File body = pixels(grey_rows);
  const File palette_header = header(2, 1, 8, 3);
  const File palette_pixels = pixels({0, 1, 0});
  const File rgb_header = header(1, 1, 8, 2);
  const File rgb_pixels = pixels({0, 1, 2, 3});
  File wrong_sum = stream(grey_rows);
  wrong_sum.back() ^= 1;
  const std::vector<std::pair<File, std::string>> table = {
      {start, "end marker"},
      {joined({start, grey_header, body}), "end marker"},
      {png({body, grey_header}), "begin with its header"},
      {png({chunk("IHDR", {0, 0}), body}), "13 bytes"},
      {png({grey_header, grey_header, body}), "two headers"},
      {png({header(0, 1, 8, 0), body}), "0 x 1 pixels"},
      {png({header(16385, 1, 8, 0), body}), "a side may have at most 16384"},
      {png({header(1, 16385, 8, 0), body}), "a side may have at most 16384"},
      {png({header(16384, 8193, 8, 0), body}), "may make at most 134217728"},
      {png({header(16384, 8192, 16, 6), body}), "MiB of memory"},
      {png({header(16384, 8192, 16, 2, 0, 0, 1), body}), "MiB of memory"},
      {png({header(8192, 8192, 8, 0), body}), "too few bytes"},
      {png({header(2, 1, 3, 0), body}), "does not exist"},
      {png({header(2, 1, 16, 3), body}), "does not exist"},
      {png({header(2, 1, 4, 4), body}), "does not exist"},
      {png({header(2, 1, 8, 7), body}), "does not exist"},
      {png({header(2, 1, 8, 0, 1), body}), "method that does not exist"},
      {png({header(2, 1, 8, 0, 0, 1), body}), "method that does not exist"},
      {png({header(2, 1, 8, 0, 0, 0, 2), body}), "method that does not exist"},
      {png({grey_header}), "it has no pixels"},
      {joined({start, grey_header, body, chunk("IEND", {0})}), "is not empty"},
      {png({grey_header, body, chunk("tEXt", {}), chunk("IDAT", {})}), "not in one piece"},
      {png({grey_header, chunk("CgBI", {}), body}), "does not know (chunk CgBI)"},
      {png({grey_header, chunk("t xt", {}), body}), "no proper name"},
      // Palette and transparency.
      {png({grey_header, two_colors, body}), "grey picture has a palette"},
      {png({palette_header, palette_pixels}), "palette (PLTE) is missing"},
      {png({palette_header, two_colors, two_colors, palette_pixels}), "two palettes"},
      {png({palette_header, chunk("PLTE", {}), palette_pixels}), "1 to 256 colors"},
      {png({palette_header, chunk("PLTE", {1, 2, 3, 4}), palette_pixels}), "1 to 256 colors"},
      {png({header(2, 1, 1, 3), three_colors, pixels({0, 0})}), "1 to 2 colors"},
      {png({rgb_header, rgb_pixels, two_colors}), "after the pixels"},
      {png({rgb_header, chunk("tRNS", File(6)), two_colors, rgb_pixels}), "after the transparency"},
      {png({palette_header, chunk("tRNS", {1}), two_colors, palette_pixels}), "before the palette"},
      {png({palette_header, two_colors, chunk("tRNS", {1, 2, 3}), palette_pixels}), "instead of 2"},
      {png({palette_header, two_colors, palette_pixels, chunk("tRNS", {1})}), "after the pixels"},
      {png({grey_header, chunk("tRNS", {1}), body}), "instead of 2"},
      {png({grey_header, chunk("tRNS", {0, 1}), chunk("tRNS", {0, 1}), body}),
       "two transparencies"},
      {png({header(1, 1, 8, 4), chunk("tRNS", {0, 1}), pixels({0, 1, 2})}), "an alpha channel"},
      {png({palette_header, two_colors, pixels({0, 1, 2})}), "color 2 of a palette with 2"},
      {png({header(1, 1, 2, 3), two_colors, pixels({0, 0x80})}), "color 2 of a palette with 2"},
      // Pixels.
      {png({grey_header, chunk("IDAT", {0x78, 0x01, 1})}), "too few bytes"},
      {png({grey_header, pixels({0, 10})}), "end after 2 of 3 bytes"},
      {png({grey_header, pixels({0, 10, 20, 30})}), "do not unpack"},
      {png({grey_header, chunk("IDAT", wrong_sum)}), "the checksum of its pixels is wrong"},
      {png({grey_header, pixels({5, 10, 20})}), "filter 5"},
      {png({header(16, 16, 8, 2), chunk("IDAT", stream_of_zeros(std::size_t{1} << 30))}),
       "do not unpack to the 784 bytes"},  // before they take memory
  };
  for (std::size_t i = 0; i < table.size(); ++i) {
    CAPTURE(i);
    const std::string said = outcome(table[i].first);
    INFO("said: ", said, ", expected: ", table[i].second);
    CHECK(said.find(table[i].second) != std::string::npos);
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
  for (const Kind& kind : std::vector<Kind>{{0, 1, 1},
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
        const File file = png({header(static_cast<std::size_t>(width), height, kind.depth,
                                      kind.color, 0, 0, interlaced ? 1 : 0),
                               palette, pixels(rows)});
        int stb_width = 0, stb_height = 0, stb_channels = 0;
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
      }
    }
  }
}

TEST_CASE("the largest picture loads") {
  const std::size_t rows = 8192 * (1 + 3 * 16384);
  const bool same = texmap::decode_image(
                        png({header(16384, 8192, 8, 2), chunk("IDAT", stream_of_zeros(rows))})) ==
                    Image(16384, 8192);
  CHECK(same);
}
