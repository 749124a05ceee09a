// Radiance .hdr files for the tests, whole and damaged, made byte by byte.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace texmap::test {

using HdrBytes = std::vector<std::uint8_t>;

inline const std::string hdr_start = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";

[[nodiscard]] inline HdrBytes bytes_of_text(const std::string& text) {
  return {text.begin(), text.end()};
}
[[nodiscard]] inline HdrBytes operator+(HdrBytes first, const HdrBytes& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}
[[nodiscard]] inline HdrBytes operator+(const std::string& first, const HdrBytes& second) {
  return bytes_of_text(first) + second;
}

/// The line of a picture's size.
[[nodiscard]] inline std::string hdr_size(const std::string& width, const std::string& height) {
  return "-Y " + height + " +X " + width + "\n";
}
[[nodiscard]] inline std::string hdr_size(int width, int height) {
  return hdr_size(std::to_string(width), std::to_string(height));
}

/// `count` times the same texel, one by one.
[[nodiscard]] inline HdrBytes flat(std::size_t count, HdrBytes texel = {128, 64, 32, 129}) {
  HdrBytes bytes;
  for (std::size_t i = 0; i < count; ++i) bytes.insert(bytes.end(), texel.begin(), texel.end());
  return bytes;
}

/// A row of the new kind: two bytes 2, the width, then the codes of the four channels.
[[nodiscard]] inline HdrBytes new_row(int width, const HdrBytes& codes) {
  return HdrBytes{2, 2, static_cast<std::uint8_t>(width >> 8),
                  static_cast<std::uint8_t>(width & 255)} +
         codes;
}

/// The codes of four channels with one run each; `width` up to 127.
[[nodiscard]] inline HdrBytes runs(int width, const HdrBytes& texel = {128, 64, 32, 129}) {
  HdrBytes codes;
  for (const std::uint8_t channel : texel) {
    codes.push_back(static_cast<std::uint8_t>(128 + width));
    codes.push_back(channel);
  }
  return codes;
}

/// A file, and what reading it must say: a part of the error's text, or nothing if it loads.
struct HdrCase {
  const char* name;
  HdrBytes file;
  const char* error;
};

/// Damaged files, one mistake each, and files at the edge of what is allowed.
[[nodiscard]] inline std::vector<HdrCase> hdr_corpus() {
  const std::string two = hdr_start + hdr_size(2, 2);
  const std::string wide = hdr_start + hdr_size(8, 2);
  const HdrBytes row = new_row(8, runs(8));
  HdrBytes long_header = bytes_of_text("#?RADIANCE\n");
  for (int i = 0; i < 2000; ++i)
    long_header = std::move(long_header) + bytes_of_text("a comment of some forty bytes, again\n");
  return {
      {"whole, flat", two + flat(4), ""},
      {"whole, runs of the new kind", wide + (row + row), ""},
      {"whole, runs of the old kind",
       wide + (flat(1) + HdrBytes{1, 1, 1, 7} + flat(1) + HdrBytes{1, 1, 1, 7}), ""},
      {"whole, the other signature",
       "#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n" + hdr_size(2, 2) + flat(4), ""},
      {"whole, with an exposure",
       "#?RADIANCE\nEXPOSURE= 2.0\nFORMAT=32-bit_rle_rgbe\n\n" + hdr_size(2, 2) + flat(4), ""},
      {"whole, with bytes behind it", two + flat(9), ""},
      {"whole, exponent 0 is black", two + flat(4, {200, 100, 50, 0}), ""},
      {"whole, literals in a row",
       wide + (new_row(8, {8, 1, 2, 3, 4, 5, 6, 7, 8, 136, 9, 136, 9, 136, 128}) + row), ""},

      {"the signature alone", bytes_of_text("#?RADIANCE\n"), "its header does not end"},
      {"a header without end", std::move(long_header), "its header does not end"},
      {"no line feed at all", bytes_of_text("#?RADIANCE\nFORMAT=32-bit_rle_rgbe"),
       "its header does not end"},
      {"no format", "#?RADIANCE\n\n" + hdr_size(2, 2) + flat(4), "it states no format"},
      {"CIE XYZ", "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n" + hdr_size(2, 2) + flat(4),
       "only 32-bit_rle_rgbe"},
      {"another format, with strange bytes",
       "#?RADIANCE\nFORMAT=\x01\xff\n\n" + hdr_size(2, 2) + flat(4), "its format is '"},
      {"lines that end in carriage returns",
       "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\r\n\r\n" + hdr_size(2, 2) + flat(4),
       "only 32-bit_rle_rgbe"},
      {"exposure 0",
       "#?RADIANCE\nEXPOSURE=0\nFORMAT=32-bit_rle_rgbe\n\n" + hdr_size(2, 2) + flat(4),
       "not a number from"},
      {"exposure below 0",
       "#?RADIANCE\nEXPOSURE=-1\nFORMAT=32-bit_rle_rgbe\n\n" + hdr_size(2, 2) + flat(4),
       "not a number from"},
      {"exposure NaN",
       "#?RADIANCE\nEXPOSURE=nan\nFORMAT=32-bit_rle_rgbe\n\n" + hdr_size(2, 2) + flat(4),
       "not a number from"},
      {"exposures that multiply to nothing",
       "#?RADIANCE\nEXPOSURE=1e-20\nEXPOSURE=1e-20\nFORMAT=32-bit_rle_rgbe\n\n" + hdr_size(2, 2) +
           flat(4),
       "not a number from"},
      {"no size", two.substr(0, hdr_start.size()) + flat(4), "its header does not end"},
      {"width 0", hdr_start + hdr_size(0, 2) + flat(4), "nothing to see"},
      {"height 0", hdr_start + hdr_size(2, 0) + flat(4), "nothing to see"},
      {"negative width", hdr_start + hdr_size(-2, 2) + flat(4), "not of the form"},
      {"negative height", hdr_start + hdr_size(2, -2) + flat(4), "not of the form"},
      {"a width of 2^31", hdr_start + hdr_size("2147483648", "2") + flat(4),
       "a side may have at most"},
      {"a width of 2^64", hdr_start + hdr_size("18446744073709551616", "2") + flat(4),
       "not of the form"},
      {"the largest sides", hdr_start + hdr_size(16384, 16384) + flat(4), "may make at most"},
      {"more texels than a sky may have", hdr_start + hdr_size(8192, 2048) + flat(4),
       "a sky may have at most"},
      {"hexadecimal", hdr_start + hdr_size("0x2", "2") + flat(4), "not of the form"},
      {"a fraction", hdr_start + hdr_size("2.5", "2") + flat(4), "not of the form"},
      {"a word behind the size", hdr_start + std::string("-Y 2 +X 2 rgb\n") + flat(4),
       "not of the form"},
      {"rows from below", hdr_start + std::string("+Y 2 +X 2\n") + flat(4),
       "only -Y +X can be read"},
      {"columns first", hdr_start + std::string("+X 2 -Y 2\n") + flat(4), "only -Y +X can be read"},
      {"no texel", bytes_of_text(two), "it ends in row 0"},
      {"half a texel", two + HdrBytes{1, 2}, "it ends in row 0"},
      {"one texel too few", two + flat(3), "it ends in row 1"},
      {"one row too few", wide + row, "it ends in row 1"},
      {"a row that states another width", wide + (new_row(9, runs(9)) + row),
       "row 0 has 9 texels, not 8"},
      {"a run too long", wide + (new_row(8, runs(9)) + row),
       "a run of 9 texels does not fit into row 0"},
      {"a run of 0", wide + new_row(8, {0, 0, 0, 0}), "a run of 0 texels"},
      {"a run without its byte", wide + new_row(8, {136}), "it ends in row 0"},
      {"literals cut off", wide + new_row(8, {8, 1, 2, 3}), "it ends in row 0"},
      {"a channel too few", wide + new_row(8, {136, 1, 136, 2, 136, 3}), "it ends in row 0"},
      {"an old run with nothing before it", wide + HdrBytes{1, 1, 1, 8},
       "a run of 8 texels does not fit into row 0"},
      {"an old run beyond its row", wide + (flat(1) + HdrBytes{1, 1, 1, 8}),
       "a run of 8 texels does not fit into row 0"},
      {"old runs without end", wide + (flat(1) + flat(9, {1, 1, 1, 0})), "does not fit into row 0"},
      {"exponent 255, brighter than any sun", two + flat(4, {255, 255, 255, 255}), "a texel has"},
      {"an exposure that makes it too bright",
       "#?RADIANCE\nEXPOSURE=1e-20\nFORMAT=32-bit_rle_rgbe\n\n" + hdr_size(2, 2) + flat(4),
       "a texel has"},
  };
}

}  // namespace texmap::test
