// The two checksums of a PNG file.
#include "engine/picture/codecs/checksums.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "number/compiler.hpp"

namespace texmap {
namespace {

using Table = std::array<std::uint32_t, 256>;

// tables[k][b] is what the byte b does to the checksum when k more bytes follow it.
TEXMAP_TABLE_CONSTEXPR std::array<Table, 8> make_tables() {
  std::array<Table, 8> tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    tables[0][byte] = crc;
  }
  for (std::size_t k = 1; k < tables.size(); ++k) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[k - 1][byte];
      tables[k][byte] = (before >> 8) ^ tables[0][before & 0xFFU];
    }
  }
  return tables;
}

TEXMAP_TABLE_CONSTEXPR const std::array<Table, 8> tables = make_tables();

// How often each of 64 bytes counts in Adler-32's second sum: the first 64 times, the last once.
constexpr auto weights = [] {
  std::array<std::int16_t, 64> result{};
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = static_cast<std::int16_t>(result.size() - k);
  return result;
}();

}  // namespace

std::uint32_t crc32(Bytes bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  std::size_t i = 0;
  for (; bytes.size() - i >= 8; i += 8) {
    std::uint32_t next = 0;
    for (std::size_t k = 0; k < 8; ++k)
      next ^= tables[7 - k][bytes[i + k] ^ (k < 4 ? crc >> (8 * k) & 0xFFU : 0U)];
    crc = next;
  }
  for (; i < bytes.size(); ++i) crc = (crc >> 8) ^ tables[0][(crc ^ bytes[i]) & 0xFFU];
  return ~crc;
}

std::uint32_t adler32(Bytes bytes) {
  constexpr std::uint32_t modulus = 65521;
  constexpr std::size_t before_overflow =
      5552;  // the most bytes of 255 that keep both sums below 2^32
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  while (!bytes.empty()) {
    const Bytes part = bytes.first(std::min(bytes.size(), before_overflow));
    std::size_t i = 0;
    // Sums without an order, of products of 16 bits: compilers have wide instructions for them.
    for (; part.size() - i >= weights.size(); i += weights.size()) {
      int sum = 0;
      int weighted = 0;
      for (std::size_t k = 0; k < weights.size(); ++k) {
        sum += part[i + k];
        weighted += weights[k] * std::int16_t{part[i + k]};
      }
      b += static_cast<std::uint32_t>(weights.size()) * a + static_cast<std::uint32_t>(weighted);
      a += static_cast<std::uint32_t>(sum);
    }
    for (; i < part.size(); ++i) {
      a += part[i];
      b += a;
    }
    a %= modulus;
    b %= modulus;
    bytes = bytes.subspan(part.size());
  }
  return (b << 16) | a;
}

}  // namespace texmap
