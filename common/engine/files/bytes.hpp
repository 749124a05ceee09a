// Bytes of a file in memory, and the numbers in them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace texmap {

using Bytes = std::span<const std::uint8_t>;

/// The number of two bytes from `place`, the most significant first; not checked.
[[nodiscard]] inline std::uint32_t big_endian_16(Bytes bytes, std::size_t place) {
  return (std::uint32_t{bytes[place]} << 8) | bytes[place + 1];
}

/// The number of four bytes from `place`, the most significant first; not checked.
[[nodiscard]] inline std::uint32_t big_endian_32(Bytes bytes, std::size_t place) {
  return (big_endian_16(bytes, place) << 16) | big_endian_16(bytes, place + 2);
}

}  // namespace texmap
