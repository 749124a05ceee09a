// The CRC-32 of bytes and of pixels, to compare pictures with sums that were made elsewhere.
#pragma once
#include <cstdio>
#include <string>

#include "engine/picture/codecs/checksums.hpp"
#include "texture/image.hpp"

namespace texmap::test {

/// As eight lower-case hexadecimal digits.
[[nodiscard]] inline std::string checksum(Bytes bytes) {
  char digits[9];
  std::snprintf(digits, sizeof digits, "%08x", crc32(bytes));
  return digits;
}

/// Of the red, green and blue bytes, row by row from the top.
[[nodiscard]] inline std::string checksum(const Image& image) {
  static_assert(sizeof(Rgb8) == 3);
  return checksum({&image.pixels[0].r, 3 * image.pixels.size()});
}

}  // namespace texmap::test
