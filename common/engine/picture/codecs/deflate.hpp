// Compresses the rows of a picture, as fast as they are drawn or as closely as zlib does.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/picture/codecs/bytes.hpp"

namespace texmap {

/// How hard to look for repetitions.
enum class Packing {
  fast,  ///< for a picture that somebody waits for
  close  ///< a third smaller, 100 times as long: for pictures that are kept
};

/// Compresses bytes into a zlib stream, by libdeflate or, where that is missing, by
/// stb_image_write. A closely packed stream begins with the bytes 78 DA.
///
/// @param bytes  at most 2^31 - 1, possibly none
/// Errors: std::bad_alloc.
[[nodiscard]] std::vector<std::uint8_t> deflate(Bytes bytes, Packing packing);

}  // namespace texmap
