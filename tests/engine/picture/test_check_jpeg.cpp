// JPEG files that are built wrongly, one mistake at a time.
#include <doctest.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "engine/picture/decode_image.hpp"
#include "engine/system/file_error.hpp"

namespace {

using File = std::vector<std::uint8_t>;

File joined(std::initializer_list<File> parts) {
  File all;
  for (const File& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

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

// "it loads", or what the error says.
std::string outcome(const File& file) {
  try {
    const texmap::Image image = texmap::decode_image(file);
    for (const texmap::Rgb8 pixel : image.pixels) {
      if (pixel != texmap::Rgb8{128, 128, 128}) return "it loads, but not as grey";
    }
    return "it loads";
  } catch (const texmap::FileError& error) {
    return error.what();
  }
}

File progressive(std::initializer_list<File> scans) {
  return joined({start, tables, frame(0xC2), joined(scans), end});
}

}  // namespace

TEST_CASE("the smallest JPEG files there are load") {
  CHECK(outcome(baseline) == "it loads");
  CHECK(outcome(progressive({scan(0, 0, 0)})) == "it loads");
  CHECK(outcome(progressive({scan(0, 0, 0), scan(1, 63, 0)})) == "it loads");
  CHECK(outcome(progressive({scan(0, 0, 1), scan(1, 63, 2), scan(0, 0, 0x10), scan(1, 63, 0x21),
                             scan(1, 63, 0x10)})) == "it loads");
  CHECK(outcome(joined({start, tables, frame(0xC1, 1, 1), scan(0, 63, 0), end, {1, 2, 3}})) ==
        "it loads");
}

TEST_CASE("a JPEG file with one mistake is refused with its reason") {
  const std::vector<std::pair<File, std::string>> table = {
      {joined({start, end}), "no picture"},
      {joined({start, tables, frame(0xC0), end}), "a color channel is missing"},
      {joined({start, tables, frame(0xC0), scan(0, 63, 0)}), "end marker is missing"},
      {joined({start, tables, {1}, frame(0xC0), scan(0, 63, 0), end}), "a segment does not begin"},
      {joined({start, {0xFF, 0xE0, 0, 1}, baseline}), "shorter than its own length"},
      {joined({start, segment(0xF0, {}), tables, frame(0xC0), scan(0, 63, 0), end}),
       "unknown kind"},
      {joined({start, tables, scan(0, 63, 0), frame(0xC0), end}), "before its header"},
      {joined({start, tables, frame(0xC0), frame(0xC0), scan(0, 63, 0), end}), "two pictures"},
      {joined({start, tables, frame(0xC3), scan(0, 63, 0), end}), "rare kind"},
      {joined({start, tables, frame(0xC9), scan(0, 63, 0), end}), "rare kind"},
      {joined({start, tables, frame(0xC0, 0), scan(0, 63, 0), end}), "8 x 0 pixels"},
      {joined({start, tables, frame(0xC0, 8, 8, 0x51), scan(0, 63, 0), end}), "sampling factor"},
      {joined({start, tables, frame(0xC0, 8, 8, 0x10), scan(0, 63, 0), end}), "sampling factor"},
      // Tables.
      {joined({start, codes, frame(0xC0), scan(0, 63, 0), end}), "a quantisation table is missing"},
      {joined({start, quantization(), frame(0xC0), scan(0, 63, 0), end}),
       "a Huffman table is missing"},
      {joined({start, quantization(4), baseline}), "quantisation table has a number"},
      {joined({start, quantization(0x20), baseline}), "quantisation table has a number"},
      {joined({start, quantization(0, 63), baseline}), "ends too early"},
      {joined({start, quantization(0x10, 64), baseline}), "ends too early"},
      {joined({start, huffman(0x20, {1}, {0}), baseline}), "Huffman table has a number"},
      {joined({start, huffman(0x04, {1}, {0}), baseline}), "Huffman table has a number"},
      {joined({start, huffman(0x00, {1}, {16}), baseline}), "symbol that does not exist"},
      {joined({start, huffman(0x00, {1}, {}), baseline}), "ends too early"},
      {joined({start, huffman(0x10, {2}, {0, 1}), baseline}), "more codes than fit"},
      {joined({start, huffman(0x10, {3}, {0, 1, 2}), baseline}), "more codes than fit"},
      {joined({start, huffman(0x10, {1, 2}, {0, 1, 2}), baseline}), "more codes than fit"},
      {joined({start, huffman(0x10, {0, 0, 0, 0, 0, 0, 0, 0, 255, 1}, File(256)), baseline}),
       "too many symbols"},
      // Scans.
      {joined({start, tables, frame(0xC0), scan(0, 63, 0), scan(0, 63, 0), end}),
       "repeat each other"},
      {joined({start, tables, frame(0xC0), scan(1, 63, 0), end}), "only progressive"},
      {joined({start, tables, frame(0xC0), scan(0, 63, 1), end}), "only progressive"},
      {joined({start, tables, frame(0xC0), scan(0, 63, 0, {}), end}), "end too early"},
      {joined({start, tables, frame(0xC0), scan(0, 63, 0, {0xFF, 0x00}), end}),
       "a code that does not exist"},
      {joined({start, tables, frame(0xC0, 8, 16), segment(0xDD, {0, 1}), scan(0, 63, 0), end}),
       "restart marker"},
      {joined({start, tables, frame(0xC0, 8, 16), segment(0xDD, {0, 1}),
               scan(0, 63, 0, {0x3F, 0xFF, 0xD1, 0x3F}), end}),
       "restart marker"},
      {joined({start, tables, frame(0xC0), segment(0xDA, {1, 2, 0, 0, 63, 0}), grey, end}),
       "does not exist"},
      {joined({start, tables, frame(0xC0), segment(0xDA, {1, 1, 0x40, 0, 63, 0}), grey, end}),
       "does not exist"},
      {joined({start, tables, frame(0xC0), segment(0xDA, {2, 1, 0, 1, 0, 0, 63, 0}), grey, end}),
       "wrong length"},
      {progressive({scan(1, 63, 0)}), "out of order"},
      {progressive({scan(0, 0, 0), scan(0, 0, 0)}), "repeat each other"},
      {progressive({scan(0, 0, 0), scan(1, 5, 0), scan(5, 9, 0)}), "repeat each other"},
      {progressive({scan(0, 0, 2), scan(0, 0, 0x10)}), "out of order"},
      {progressive({scan(0, 0, 2), scan(0, 0, 0x20)}), "bits that do not follow"},
      {progressive({scan(0, 0, 14)}), "bits that do not follow"},
      {progressive({scan(0, 63, 0)}), "frequencies"},
      {progressive({scan(0, 0, 0), scan(1, 64, 0)}), "frequencies"},
      {progressive({scan(0, 0, 0), scan(5, 4, 0)}), "frequencies"},
      {progressive({scan(0, 0, 0), scan(1, 63, 0, {})}), "end too early"},
  };
  for (std::size_t i = 0; i < table.size(); ++i) {
    CAPTURE(i);
    const std::string said = outcome(table[i].first);
    INFO("said: ", said, ", expected: ", table[i].second);
    CHECK(said.find(table[i].second) != std::string::npos);
  }
  CHECK(table.size() == 47);
}

namespace {

// A picture of several channels, each with a number, sampling factors and a quantisation table.
File colors(std::initializer_list<File> channels, std::uint8_t width = 8) {
  File data = {8, 0, 8, 0, width, static_cast<std::uint8_t>(channels.size())};
  for (const File& channel : channels) data.insert(data.end(), channel.begin(), channel.end());
  return joined({start,
                 tables,
                 segment(0xC0, data),
                 segment(0xDA, {3, 1, 0, 2, 0, 3, 0, 0, 63, 0}),
                 {0, 0, 0, 0},
                 end});
}

// Two codes for the constant part: 0 for no difference, 10 for the largest. Three for the others: 0
// ends the block, 10 and 110 have the symbols `second` and `third`.
File wide_codes(std::uint8_t constant, std::uint8_t second, std::uint8_t third) {
  return joined(
      {huffman(0x00, {1, 1}, {0, constant}), huffman(0x10, {1, 1, 1}, {0, second, third})});
}

File coded(std::uint8_t second, std::uint8_t third, std::uint8_t marker, std::uint8_t blocks,
           const File& scans) {
  const auto width = static_cast<std::uint8_t>(8 * blocks);
  return joined(
      {start, quantization(), wide_codes(15, second, third), frame(marker, 8, width), scans, end});
}

}  // namespace

TEST_CASE("the channels of a JPEG file must fit together") {
  CHECK(outcome(colors({{1, 0x11, 0}, {2, 0x11, 0}, {3, 0x11, 0}})) == "it loads");
  CHECK(outcome(colors({{1, 0x21, 0}, {2, 0x11, 0}, {3, 0x11, 0}})) == "it loads");
  CHECK(outcome(colors({{1, 0x11, 0}, {1, 0x11, 0}, {3, 0x11, 0}})).find("the same number") !=
        std::string::npos);
  CHECK(outcome(colors({{1, 0x31, 0}, {2, 0x21, 0}, {3, 0x11, 0}})).find("do not divide") !=
        std::string::npos);
  CHECK(outcome(colors({{1, 0x11, 4}, {2, 0x11, 0}, {3, 0x11, 0}})).find("names a quantisation") !=
        std::string::npos);
  CHECK(outcome(colors({{1, 0x11, 1}, {2, 0x11, 0}, {3, 0x11, 0}})).find("table is missing") !=
        std::string::npos);
  CHECK(outcome(colors({{1, 0x11, 0}, {2, 0x11, 0}, {3, 0x11, 0, 9}})).find("wrong length") !=
        std::string::npos);
  CHECK(outcome(joined({start, segment(0xDD, {0, 0, 0}), baseline})).find("restart interval") !=
        std::string::npos);
}

TEST_CASE("codes of a JPEG file that make no sense are refused") {
  const std::string nonsense =
      "the JPEG file is damaged: its pixels have a code that makes no sense";
  // The constant part grows by 32767 in each block: once is allowed, twice is not. A block is 10,
  // then 15 ones, then 0.
  CHECK(outcome(coded(1, 2, 0xC0, 1, scan(0, 63, 0, {0xBF, 0xFF, 0x00, 0x80 >> 1}))) != nonsense);
  CHECK(outcome(coded(1, 2, 0xC0, 2, scan(0, 63, 0, {0xBF, 0xFF, 0x00, 0xAF, 0xFF, 0x00, 0xD0}))) ==
        nonsense);
  // Four runs of 15 zeros and a coefficient end at the 64th; with the constant part it is the 65th.
  // The bits are 10 and one more.
  CHECK(outcome(coded(0xF1, 2, 0xC0, 1, scan(0, 63, 0, {0x49, 0x00}))) != nonsense);
  CHECK(outcome(coded(0xF1, 2, 0xC0, 1, scan(0, 63, 0, {0x49, 0x20}))) == nonsense);
  // Progressive: a coefficient behind the last of the scan, and one with more bits than there are.
  const File dc = scan(0, 0, 0, {0x00});
  CHECK(outcome(coded(0x21, 2, 0xC2, 1, joined({dc, scan(1, 3, 0, {0x80})}))) != nonsense);
  CHECK(outcome(coded(0x31, 2, 0xC2, 1, joined({dc, scan(1, 3, 0, {0x80})}))) == nonsense);
  CHECK(outcome(coded(0x02, 2, 0xC2, 1, joined({dc, scan(1, 1, 13, {0x80})}))) != nonsense);
  CHECK(outcome(coded(0x03, 2, 0xC2, 1, joined({dc, scan(1, 1, 13, {0x80})}))) == nonsense);
  // Making finer: a new coefficient is one bit large.
  const File first = scan(1, 3, 1, {0x00});
  CHECK(outcome(coded(0x01, 2, 0xC2, 1, joined({dc, first, scan(1, 3, 0x10, {0x80})}))) !=
        nonsense);
  CHECK(outcome(coded(0x02, 2, 0xC2, 1, joined({dc, first, scan(1, 3, 0x10, {0x80})}))) ==
        nonsense);
}

TEST_CASE("a code that ends several blocks at once ends exactly as many as it says") {
  // 10 and two bits end 4 to 7 blocks. If one more code is needed, the file loads only if it has
  // bits for it.
  const File dc = scan(0, 0, 0, {0x00, 0x00});
  const std::string short_of_bits =
      "the JPEG file is cut short or damaged: its pixels end too early";
  for (const bool finer : {false, true}) {
    const File before = finer ? joined({dc, scan(1, 63, 1, {0x00, 0x00})}) : dc;
    const std::uint8_t bits = finer ? 0x10 : 0;
    for (const std::uint8_t blocks : {std::uint8_t{14}, std::uint8_t{15}}) {
      CAPTURE(finer);
      CAPTURE(static_cast<int>(blocks));
      // Two codes of 1011, each for 7 blocks, fill a byte: enough for 14 blocks, not for 15.
      const std::string said =
          outcome(coded(0x20, 2, 0xC2, blocks, joined({before, scan(1, 63, bits, {0xBB})})));
      CHECK(said == (blocks == 14 ? "it loads" : short_of_bits));
    }
  }
}

TEST_CASE("a coefficient that was sent takes a bit each time its block is made finer") {
  // Each block sends one coefficient, 10 and a bit, and its end, 0. Refining takes two bits a
  // block, so a byte is enough for 4 blocks.
  const File before = joined({scan(0, 0, 0, {0x00}), scan(1, 63, 1, {0xAA, 0xAA, 0xA0})});
  const File all = joined({before, scan(1, 63, 0x10, {0x00})});
  CHECK(outcome(coded(0x01, 2, 0xC2, 4, all)).substr(0, 8) == "it loads");
  const std::string short_of_bits =
      "the JPEG file is cut short or damaged: its pixels end too early";
  CHECK(outcome(coded(0x01, 2, 0xC2, 5, all)) == short_of_bits);
  // So it does where a new coefficient, 10 and a bit, is placed behind it: with the end 5 bits a
  // block, and 5 bytes are enough for 8 blocks.
  const File eight =
      joined({scan(0, 0, 0, {0x00, 0x00}), scan(1, 63, 1, {0xAA, 0xAA, 0xAA, 0xAA, 0xA0}),
              scan(1, 63, 0x10, {0x84, 0x21, 0x08, 0x42, 0x10})});
  CHECK(outcome(coded(0x01, 2, 0xC2, 8, eight)).substr(0, 8) == "it loads");
  CHECK(outcome(coded(0x01, 2, 0xC2, 9, eight)) == short_of_bits);
}

TEST_CASE("a scan reads what its kind of file holds, and nothing of the scan before it") {
  const std::string short_of_bits =
      "the JPEG file is cut short or damaged: its pixels end too early";
  // In a baseline file the last coefficient is always 63: eight blocks of two bits need two bytes.
  CHECK(outcome(joined({start, tables, frame(0xC0, 8, 64), scan(0, 0, 0, {0x00}), end})) ==
        short_of_bits);
  // There a code for the end of several blocks, 10, ends just one: 0, 10, eight times.
  CHECK(outcome(coded(0x10, 2, 0xC0, 8, scan(0, 63, 0, {0x49, 0x24, 0x92}))) == "it loads");
  // A channel alone is sent without the blocks that fill up a unit.
  CHECK(outcome(joined({start, tables, frame(0xC0, 8, 16, 0x22), scan(0, 63, 0, {0x0F}), end})) ==
        "it loads");
  // 1011 ends seven blocks, but only of this scan.
  const File before = joined({scan(0, 0, 0, {0x00}), scan(1, 31, 0, {0xBB})});
  CHECK(outcome(coded(0x20, 2, 0xC2, 1, joined({before, scan(32, 63, 0, {0x7F})}))) == "it loads");
  CHECK(outcome(coded(0x20, 2, 0xC2, 1, joined({before, scan(32, 63, 0, {})}))) == short_of_bits);
}

TEST_CASE("a JPEG file that would take more than 1 GiB is refused before its pixels are read") {
  const auto outcome_of = [](std::uint8_t marker) {
    return outcome(joined(
        {start, tables,
         segment(marker, {8, 0x20, 0, 0x40, 0, 3, 1, 0x11, 0, 2, 0x11, 0, 3, 0x11, 0}), end}));
  };
  CHECK(outcome_of(0xC2).find("1537 MiB of memory") != std::string::npos);
  CHECK(outcome_of(0xC0).find("a color channel is missing") != std::string::npos);
}

TEST_CASE("a file that visits 2^26 blocks is read, and one that visits more is refused") {
  // The codes of 32767 empty blocks are so short that a few kilobytes could keep the decoder busy
  // for minutes. This picture has 2^20 blocks, and each scan visits all of them.
  File all = joined({start, quantization(), huffman(0x00, {1}, {0}), huffman(0x10, {1}, {0xE0}),
                     segment(0xC2, {8, 0x10, 0x00, 0x40, 0x00, 1, 1, 0x11, 0}),
                     scan(0, 0, 0, File(131072, 0))});
  const File many_blocks(240, 0);
  for (std::uint8_t k = 1; k < 64; ++k) {
    const File next = scan(k, k, 1, many_blocks);
    all.insert(all.end(), next.begin(), next.end());
  }
  // Without an end, so that nothing has to be decoded.
  CHECK(outcome(all).find("end marker is missing") != std::string::npos);
  CHECK(outcome(joined({all, scan(1, 1, 0x10, many_blocks)})).find("too many scans for its size") !=
        std::string::npos);
}

TEST_CASE("a restart marker begins the constant part and the empty blocks again") {
  // 32767 in each of two blocks is too much in a row, but not with a restart between them.
  const File block = {0xBF, 0xFF, 0x00, 0x40};
  const File data = joined({block, {0xFF, 0xD0}, block});
  const File file = joined({start, quantization(), wide_codes(15, 1, 2), frame(0xC0, 8, 16),
                            segment(0xDD, {0, 1}), scan(0, 63, 0, data), end});
  CHECK(outcome(file) == "it loads, but not as grey");
  // The first block says that the next ones are empty too. The restart ends that.
  for (const bool complete : {true, false}) {
    const File second = complete ? File{0x00} : File{};
    const File scans = joined({scan(0, 0, 0, {0x7F, 0xFF, 0xD0, 0x7F}),
                               scan(1, 63, 0, joined({{0x80, 0xFF, 0xD0}, second}))});
    const std::string said =
        outcome(coded(0x20, 2, 0xC2, 2, joined({segment(0xDD, {0, 1}), scans})));
    CHECK(said == (complete ? "it loads"
                            : "the JPEG file is cut short or damaged: its pixels end too early"));
  }
  // A whole byte before the marker that no code has used.
  const File spare = joined({start, tables, frame(0xC0, 8, 16), segment(0xDD, {0, 1}),
                             scan(0, 63, 0, {0x3F, 0x3F, 0xFF, 0xD0, 0x3F}), end});
  CHECK(outcome(spare).find("restart marker") != std::string::npos);
}

TEST_CASE("restart markers in their places load") {
  const File data = {0x3F, 0xFF, 0xD0,
                     0x3F};  // a zero bit for the constant part and one for the rest
  CHECK(outcome(joined({start, tables, frame(0xC0, 8, 16), segment(0xDD, {0, 1}),
                        scan(0, 63, 0, data), end})) == "it loads");
  CHECK(outcome(joined({start, tables, frame(0xC0, 8, 16), segment(0xDD, {0, 2}),
                        scan(0, 63, 0, {0x0F}), end})) == "it loads");
}

TEST_CASE("256 scans load and one more is refused") {
  for (const int scans : {256, 257}) {
    File all = joined({start, tables, frame(0xC2), scan(0, 0, 0)});
    int made = 1;
    for (std::uint8_t k = 1; k < 64; ++k) {
      for (int bit = 13; bit >= 0 && made < scans; --bit, ++made) {
        const int before = bit == 13 ? 0 : bit + 1;
        const File next = scan(k, k, static_cast<std::uint8_t>(16 * before + bit));
        all.insert(all.end(), next.begin(), next.end());
      }
    }
    all.insert(all.end(), end.begin(), end.end());
    REQUIRE(made == scans);
    CHECK(outcome(all) == (scans == 256 ? "it loads" : "the JPEG file has more than 256 scans"));
  }
}

TEST_CASE("1024 Huffman tables load and one more is refused") {
  for (const int extra : {1022, 1023}) {
    File all = start;
    for (int i = 0; i < extra; ++i) {
      const File table = huffman(0x03, {1}, {0});
      all.insert(all.end(), table.begin(), table.end());
    }
    const File rest(baseline.begin() + 2, baseline.end());
    CHECK(outcome(joined({all, rest})) ==
          (extra == 1022 ? "it loads" : "the JPEG file has more than 1024 Huffman tables"));
  }
}
