// Compresses the rows of a picture, as fast as they are drawn or as closely as zlib does.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/picture/codecs/bytes.hpp"

namespace texmap {

/// How hard to look for repetitions.
enum class Packing {
  fast,  ///< for a picture that somebody waits for
  close  ///< a third smaller, 200 times as long: for pictures that are kept
};

/// Room that deflate() needs for so many bytes: nine bits for each, and what is around them.
[[nodiscard]] constexpr std::size_t most_deflated_bytes(std::size_t size) {
  return size + size / 8 + size / 512 + 32;
}

/// Compresses bytes into a zlib stream; the same bytes give the same stream on every machine.
/// @param bytes   at most 2^32 - 1, possibly none
/// @param room    at least most_deflated_bytes(bytes.size()); all of it may be overwritten
/// @param period  where fast packing looks, too: a distance such as that of rows; 0 for none
/// @return        bytes of `room` that the stream takes
/// Source: RFC 1950, RFC 1951; fast repetitions as in LZRW1 (Williams, 1991).
[[nodiscard]] std::size_t deflate(Bytes bytes, std::span<std::uint8_t> room, Packing packing,
                                  std::size_t period = 0);

}  // namespace texmap
