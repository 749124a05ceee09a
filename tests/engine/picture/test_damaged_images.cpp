// PNG and JPEG files that are built wrongly, one mistake at a time, and what loading them says.
// Those of the corpus are in test_load_image, .hdr files in test_read_hdr.
#include <doctest.h>

#include <initializer_list>
#include <string>
#include <vector>

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

const std::string loads = "it loads";
const std::string all_grey = "it loads, all grey";

std::string outcome(const File& file) {
  try {
    for (const Rgb8 pixel : texmap::decode_image(file).pixels) {
      if (pixel != Rgb8{128, 128, 128}) return loads;
    }
    return all_grey;
  } catch (const texmap::FileError& error) {
    return error.what();
  }
}

// A file, and a part of what loading it says.
struct Case {
  File file;
  std::string says;
};

void check(const std::vector<Case>& table) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    CAPTURE(i);
    const std::string said = outcome(table[i].file);
    INFO("said: ", said, ", expected: ", table[i].says);
    CHECK(said.find(table[i].says) != std::string::npos);
  }
}

}  // namespace

namespace png {
namespace {

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

File png(std::initializer_list<File> chunks) { return joined({start, joined(chunks), end}); }

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
  check({
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
      {png({header(8192, 8192, 8, 0), body}), "too few bytes"},
      {png({header(2, 1, 3, 0), body}), "does not exist"},
      {png({header(2, 1, 16, 3), body}), "does not exist"},
      {png({header(2, 1, 8, 7), body}), "does not exist"},
      {png({header(2, 1, 8, 0, 1), body}), "method that does not exist"},
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
  });
}

}  // namespace png

namespace jpeg {
namespace {

// A segment: its marker, its length and its data.
File segment(std::uint8_t marker, const File& data) {
  const std::size_t length = data.size() + 2;
  return joined({{0xFF, marker, static_cast<std::uint8_t>(length >> 8),
                  static_cast<std::uint8_t>(length & 0xFFU)},
                 data});
}

const File start = {0xFF, 0xD8};
const File end = {0xFF, 0xD9};
const File grey = {0x3F};  // two zero bits, and ones that fill up the byte

File quantization(std::uint8_t kind = 0, std::size_t entries = 64) {
  return segment(0xDB, joined({{kind}, File(entries, 1)}));
}

// How many codes of each length, and their symbols.
File huffman(std::uint8_t kind, const File& codes, const File& symbols) {
  File counts = codes;
  counts.resize(16);
  return segment(0xC4, joined({{kind}, counts, symbols}));
}

// A zero bit means "nothing": no difference to the block before, no coefficient in this one.
const File codes = joined({huffman(0x00, {1}, {0}), huffman(0x10, {1}, {0})});

File frame(std::uint8_t marker, std::uint8_t height = 8, std::uint8_t width = 8,
           std::uint8_t sampling = 0x11) {
  return segment(marker, {8, 0, height, 0, width, 1, 1, sampling, 0});
}

File scan(std::uint8_t first, std::uint8_t last, std::uint8_t bits, const File& data = grey) {
  return joined({segment(0xDA, {1, 1, 0x00, first, last, bits}), data});
}

const File tables = joined({quantization(), codes});
const File baseline = joined({start, tables, frame(0xC0), scan(0, 63, 0), end});

File progressive(std::initializer_list<File> scans) {
  return joined({start, tables, frame(0xC2), joined(scans), end});
}

// A baseline file with its tables and a header of 8 x 8 pixels before these parts.
File framed(std::initializer_list<File> parts) {
  return joined({start, tables, frame(0xC0), joined(parts), end});
}

// The same with a restart interval, 16 pixels wide.
File restarting(std::uint8_t interval, const File& data) {
  return joined(
      {start, tables, frame(0xC0, 8, 16), segment(0xDD, {0, interval}), scan(0, 63, 0, data), end});
}

// A picture of several channels, each with a number, sampling factors and a quantisation table.
File colors(std::initializer_list<File> channels) {
  const File data =
      joined({{8, 0, 8, 0, 8, static_cast<std::uint8_t>(channels.size())}, joined(channels)});
  const File header = segment(0xDA, {3, 1, 0, 2, 0, 3, 0, 0, 63, 0});
  return joined({start, tables, segment(0xC0, data), header, {0, 0, 0, 0}, end});
}

// Two codes for the constant part: 0 for no difference, 10 for the largest. Three for the others: 0
// ends the block, 10 and 110 have the symbols `second` and `third`.
File coded(std::uint8_t second, std::uint8_t third, std::uint8_t marker, std::uint8_t blocks,
           std::initializer_list<File> scans) {
  return joined({start, quantization(), huffman(0x00, {1, 1}, {0, 15}),
                 huffman(0x10, {1, 1, 1}, {0, second, third}),
                 frame(marker, 8, static_cast<std::uint8_t>(8 * blocks)), joined(scans), end});
}

File without_start(const File& file) { return {file.begin() + 2, file.end()}; }

const std::string short_of_bits = "cut short or damaged: its pixels end too early";
const std::string nonsense = "its pixels have a code that makes no sense";

}  // namespace

TEST_CASE("the smallest JPEG files there are load") {
  check({
      {baseline, all_grey},
      {progressive({scan(0, 0, 0)}), all_grey},
      {progressive({scan(0, 0, 0), scan(1, 63, 0)}), all_grey},
      {progressive(
           {scan(0, 0, 1), scan(1, 63, 2), scan(0, 0, 0x10), scan(1, 63, 0x21), scan(1, 63, 0x10)}),
       all_grey},
      {joined({start, tables, frame(0xC1, 1, 1), scan(0, 63, 0), end, {1, 2, 3}}), all_grey},
      {colors({{1, 0x11, 0}, {2, 0x11, 0}, {3, 0x11, 0}}), all_grey},
      {colors({{1, 0x21, 0}, {2, 0x11, 0}, {3, 0x11, 0}}), all_grey},
      // A channel alone is sent without the blocks that fill up a unit.
      {joined({start, tables, frame(0xC0, 8, 16, 0x22), scan(0, 63, 0, {0x0F}), end}), all_grey},
      {restarting(1, {0x3F, 0xFF, 0xD0, 0x3F}), all_grey},
      {restarting(2, {0x0F}), all_grey},
  });
}

TEST_CASE("a JPEG file with one mistake is refused with its reason") {
  check({
      {joined({start, end}), "no picture"},
      {framed({}), "a color channel is missing"},
      {joined({start, tables, frame(0xC0), scan(0, 63, 0)}), "end marker is missing"},
      {joined({start, tables, {1}, frame(0xC0), scan(0, 63, 0), end}), "a segment does not begin"},
      {joined({start, {0xFF, 0xE0, 0, 1}, baseline}), "shorter than its own length"},
      {joined({start, segment(0xF0, {}), tables, frame(0xC0), scan(0, 63, 0), end}),
       "unknown kind"},
      {joined({start, tables, scan(0, 63, 0), frame(0xC0), end}), "before its header"},
      {framed({frame(0xC0), scan(0, 63, 0)}), "two pictures"},
      {joined({start, tables, frame(0xC3), scan(0, 63, 0), end}), "rare kind"},
      {joined({start, tables, frame(0xC0, 0), scan(0, 63, 0), end}), "8 x 0 pixels"},
      // Channels.
      {joined({start, tables, frame(0xC0, 8, 8, 0x51), scan(0, 63, 0), end}), "sampling factor"},
      {colors({{1, 0x11, 0}, {1, 0x11, 0}, {3, 0x11, 0}}), "the same number"},
      {colors({{1, 0x31, 0}, {2, 0x21, 0}, {3, 0x11, 0}}), "do not divide"},
      {colors({{1, 0x11, 4}, {2, 0x11, 0}, {3, 0x11, 0}}), "names a quantisation"},
      {colors({{1, 0x11, 1}, {2, 0x11, 0}, {3, 0x11, 0}}), "table is missing"},
      {colors({{1, 0x11, 0}, {2, 0x11, 0}, {3, 0x11, 0, 9}}), "wrong length"},
      // Tables.
      {joined({start, codes, frame(0xC0), scan(0, 63, 0), end}), "a quantisation table is missing"},
      {joined({start, quantization(), frame(0xC0), scan(0, 63, 0), end}),
       "a Huffman table is missing"},
      {joined({start, segment(0xDD, {0, 0, 0}), baseline}), "restart interval"},
      {joined({start, quantization(4), baseline}), "quantisation table has a number"},
      {joined({start, quantization(0x20), baseline}), "quantisation table has a number"},
      {joined({start, quantization(0, 63), baseline}), "ends too early"},
      {joined({start, huffman(0x20, {1}, {0}), baseline}), "Huffman table has a number"},
      {joined({start, huffman(0x04, {1}, {0}), baseline}), "Huffman table has a number"},
      {joined({start, huffman(0x00, {1}, {16}), baseline}), "symbol that does not exist"},
      {joined({start, huffman(0x00, {1}, {}), baseline}), "ends too early"},
      {joined({start, huffman(0x10, {2}, {0, 1}), baseline}), "more codes than fit"},
      {joined({start, huffman(0x10, {1, 2}, {0, 1, 2}), baseline}), "more codes than fit"},
      {joined({start, huffman(0x10, {0, 0, 0, 0, 0, 0, 0, 0, 255, 1}, File(256)), baseline}),
       "too many symbols"},
      // Scans.
      {framed({scan(0, 63, 0), scan(0, 63, 0)}), "repeat each other"},
      {framed({scan(1, 63, 0)}), "only progressive"},
      {framed({scan(0, 63, 1)}), "only progressive"},
      {framed({scan(0, 63, 0, {})}), short_of_bits},
      {framed({scan(0, 63, 0, {0xFF, 0x00})}), "a code that does not exist"},
      {restarting(1, grey), "restart marker"},
      {restarting(1, {0x3F, 0xFF, 0xD1, 0x3F}), "restart marker"},
      // A whole byte before the marker that no code has used.
      {restarting(1, {0x3F, 0x3F, 0xFF, 0xD0, 0x3F}), "restart marker"},
      {framed({segment(0xDA, {1, 2, 0, 0, 63, 0}), grey}), "does not exist"},
      {framed({segment(0xDA, {1, 1, 0x40, 0, 63, 0}), grey}), "does not exist"},
      {framed({segment(0xDA, {2, 1, 0, 1, 0, 0, 63, 0}), grey}), "wrong length"},
      {progressive({scan(1, 63, 0)}), "out of order"},
      {progressive({scan(0, 0, 0), scan(0, 0, 0)}), "repeat each other"},
      {progressive({scan(0, 0, 0), scan(1, 5, 0), scan(5, 9, 0)}), "repeat each other"},
      {progressive({scan(0, 0, 2), scan(0, 0, 0x10)}), "out of order"},
      {progressive({scan(0, 0, 2), scan(0, 0, 0x20)}), "bits that do not follow"},
      {progressive({scan(0, 0, 14)}), "bits that do not follow"},
      {progressive({scan(0, 63, 0)}), "frequencies"},
      {progressive({scan(0, 0, 0), scan(1, 64, 0)}), "frequencies"},
      {progressive({scan(0, 0, 0), scan(5, 4, 0)}), "frequencies"},
      {progressive({scan(0, 0, 0), scan(1, 63, 0, {})}), short_of_bits},
  });
}

TEST_CASE("codes of a JPEG file that make no sense are refused, and their neighbors are not") {
  const File dc = scan(0, 0, 0, {0x00});
  const File first = scan(1, 3, 1, {0x00});
  check({
      // The constant part grows by 32767 in each block: once is allowed, twice is not, but with a
      // restart between them. A block is 10, then 15 ones, then 0.
      {coded(1, 2, 0xC0, 1, {scan(0, 63, 0, {0xBF, 0xFF, 0x00, 0x40})}), loads},
      {coded(1, 2, 0xC0, 2, {scan(0, 63, 0, {0xBF, 0xFF, 0x00, 0xAF, 0xFF, 0x00, 0xD0})}),
       nonsense},
      {joined(
           {start, segment(0xDD, {0, 1}),
            without_start(coded(
                1, 2, 0xC0, 2,
                {scan(0, 63, 0, {0xBF, 0xFF, 0x00, 0x40, 0xFF, 0xD0, 0xBF, 0xFF, 0x00, 0x40})}))}),
       loads},
      // Four runs of 15 zeros and a coefficient end at the 64th; with the constant part it is the
      // 65th. The bits are 10 and one more.
      {coded(0xF1, 2, 0xC0, 1, {scan(0, 63, 0, {0x49, 0x00})}), loads},
      {coded(0xF1, 2, 0xC0, 1, {scan(0, 63, 0, {0x49, 0x20})}), nonsense},
      // Progressive: a coefficient behind the last of the scan, and one with too many bits.
      {coded(0x21, 2, 0xC2, 1, {dc, scan(1, 3, 0, {0x80})}), loads},
      {coded(0x31, 2, 0xC2, 1, {dc, scan(1, 3, 0, {0x80})}), nonsense},
      {coded(0x02, 2, 0xC2, 1, {dc, scan(1, 1, 13, {0x80})}), loads},
      {coded(0x03, 2, 0xC2, 1, {dc, scan(1, 1, 13, {0x80})}), nonsense},
      // Making finer: a new coefficient is one bit large.
      {coded(0x01, 2, 0xC2, 1, {dc, first, scan(1, 3, 0x10, {0x80})}), loads},
      {coded(0x02, 2, 0xC2, 1, {dc, first, scan(1, 3, 0x10, {0x80})}), nonsense},
  });
}

TEST_CASE("a scan takes exactly the bits that its codes say, and nothing of the scan before it") {
  const File dc = scan(0, 0, 0, {0x00, 0x00});
  const File finer = scan(1, 63, 1, {0x00, 0x00});
  // Each block sends one coefficient, 10 and a bit, and its end, 0.
  const File sent = scan(1, 63, 1, {0xAA, 0xAA, 0xA0});
  const File sent_by_nine = scan(1, 63, 1, {0xAA, 0xAA, 0xAA, 0xAA, 0xA0});
  const File five_bytes = scan(1, 63, 0x10, {0x84, 0x21, 0x08, 0x42, 0x10});
  const File seven_ended = joined({scan(0, 0, 0, {0x00}), scan(1, 31, 0, {0xBB})});
  const File restart = segment(0xDD, {0, 1});
  const File dc_with_restart = scan(0, 0, 0, {0x7F, 0xFF, 0xD0, 0x7F});
  check({
      // 10 and two bits end 4 to 7 blocks: 1011 twice is enough for 14, but not for 15.
      {coded(0x20, 2, 0xC2, 14, {dc, scan(1, 63, 0, {0xBB})}), all_grey},
      {coded(0x20, 2, 0xC2, 15, {dc, scan(1, 63, 0, {0xBB})}), short_of_bits},
      {coded(0x20, 2, 0xC2, 14, {dc, finer, scan(1, 63, 0x10, {0xBB})}), all_grey},
      {coded(0x20, 2, 0xC2, 15, {dc, finer, scan(1, 63, 0x10, {0xBB})}), short_of_bits},
      // Only those of this scan, and only up to a restart.
      {coded(0x20, 2, 0xC2, 1, {seven_ended, scan(32, 63, 0, {0x7F})}), all_grey},
      {coded(0x20, 2, 0xC2, 1, {seven_ended, scan(32, 63, 0, {})}), short_of_bits},
      {coded(0x20, 2, 0xC2, 2, {restart, dc_with_restart, scan(1, 63, 0, {0x80, 0xFF, 0xD0, 0})}),
       all_grey},
      {coded(0x20, 2, 0xC2, 2, {restart, dc_with_restart, scan(1, 63, 0, {0x80, 0xFF, 0xD0})}),
       short_of_bits},
      // In a baseline file such a code, 10, ends just one: 0, 10, eight times.
      {coded(0x10, 2, 0xC0, 8, {scan(0, 63, 0, {0x49, 0x24, 0x92})}), all_grey},
      // There the last coefficient is always 63: eight blocks of two bits need two bytes.
      {joined({start, tables, frame(0xC0, 8, 64), scan(0, 0, 0, {0x00}), end}), short_of_bits},
      // Making finer takes a bit of each coefficient sent before: two bits a block, with the end.
      {coded(0x01, 2, 0xC2, 4, {dc, sent, scan(1, 63, 0x10, {0x00})}), loads},
      {coded(0x01, 2, 0xC2, 5, {dc, sent, scan(1, 63, 0x10, {0x00})}), short_of_bits},
      // So it does where a new coefficient, 10 and a bit, is placed behind it: 5 bits a block.
      {coded(0x01, 2, 0xC2, 8, {dc, sent_by_nine, five_bytes}), loads},
      {coded(0x01, 2, 0xC2, 9, {dc, sent_by_nine, five_bytes}), short_of_bits},
  });
}

TEST_CASE("a JPEG file that would take more than 1 GiB is refused before its pixels are read") {
  const auto large = [](std::uint8_t marker) {
    const File header = {8, 0x20, 0, 0x40, 0, 3, 1, 0x11, 0, 2, 0x11, 0, 3, 0x11, 0};
    return joined({start, tables, segment(marker, header), end});
  };
  check({{large(0xC2), "1537 MiB of memory"}, {large(0xC0), "a color channel is missing"}});
}

TEST_CASE("a file that visits 2^26 blocks is read, and one that visits more is refused") {
  // The codes of 32767 empty blocks are so short that a few kilobytes could keep the decoder busy
  // for minutes. This picture has 2^20 blocks, and each scan visits all of them.
  File all = joined({start, quantization(), huffman(0x00, {1}, {0}), huffman(0x10, {1}, {0xE0}),
                     segment(0xC2, {8, 0x10, 0x00, 0x40, 0x00, 1, 1, 0x11, 0}),
                     scan(0, 0, 0, File(131072, 0))});
  const File many_blocks(240, 0);
  for (std::uint8_t k = 1; k < 64; ++k) all = joined({all, scan(k, k, 1, many_blocks)});
  // Without an end, so that nothing has to be decoded.
  check({{all, "end marker is missing"},
         {joined({all, scan(1, 1, 0x10, many_blocks)}), "too many scans for its size"}});
}

}  // namespace jpeg
