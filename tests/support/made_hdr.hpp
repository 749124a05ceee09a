// Radiance .hdr files for the tests, made byte by byte.
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
[[nodiscard]] inline std::string hdr_size(int width, int height) {
  return "-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
}

/// `count` times the same texel, one by one.
[[nodiscard]] inline HdrBytes flat(std::size_t count, HdrBytes texel = {128, 64, 32, 129}) {
  HdrBytes bytes;
  for (std::size_t i = 0; i < count; ++i) bytes.insert(bytes.end(), texel.begin(), texel.end());
  return bytes;
}

}  // namespace texmap::test
