// The two checksums of a PNG file, by libdeflate or by their definitions.
#include "engine/picture/codecs/checksums.hpp"

#ifdef TEXMAP_HAVE_LIBDEFLATE
#include <libdeflate.h>
#else
#include <algorithm>
#include <array>
#endif

namespace texmap {

#ifdef TEXMAP_HAVE_LIBDEFLATE

std::uint32_t crc32(Bytes bytes) { return libdeflate_crc32(0, bytes.data(), bytes.size()); }
std::uint32_t adler32(Bytes bytes) { return libdeflate_adler32(1, bytes.data(), bytes.size()); }

#else

std::uint32_t crc32(Bytes bytes) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> made{};
    for (std::uint32_t byte = 0; byte < made.size(); ++byte) {
      std::uint32_t crc = byte;
      for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
      made[byte] = crc;
    }
    return made;
  }();
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const std::uint8_t byte : bytes) crc = (crc >> 8) ^ table[(crc ^ byte) & 0xFFU];
  return ~crc;
}

std::uint32_t adler32(Bytes bytes) {
  constexpr std::size_t before_overflow = 5552;  // bytes of 255 that keep both sums below 2^32
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  while (!bytes.empty()) {
    const Bytes part = bytes.first(std::min(bytes.size(), before_overflow));
    for (const std::uint8_t byte : part) {
      a += byte;
      b += a;
    }
    a %= 65521;
    b %= 65521;
    bytes = bytes.subspan(part.size());
  }
  return (b << 16) | a;
}

#endif

}  // namespace texmap
