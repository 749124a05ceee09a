// How large a picture may be. Known before anything is decoded, so that a small file cannot ask for a large amount of work.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

#include "image_error.hpp"

namespace texmap {

inline constexpr std::uint32_t max_image_side = 16384;                   // pixels
inline constexpr std::uint64_t max_image_area = std::uint64_t{1} << 26;  // pixels
inline constexpr std::size_t max_file_bytes = std::size_t{64} << 20;
inline constexpr std::uint64_t max_decoding_bytes = std::uint64_t{512} << 20;

/// Refuses a picture with no pixels or too many.
///
/// @param width   pixels, any number a header can hold
/// @param height  pixels, any number a header can hold
/// Errors: Refusal.
inline void check_image_size(std::uint64_t width, std::uint64_t height) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width == 0 || height == 0) throw Refusal("its size is " + size + ", so there is nothing to see");
  if (width > max_image_side || height > max_image_side) {
    throw Refusal("its size is " + size + ", and a side may have at most " + std::to_string(max_image_side));
  }
  if (width * height > max_image_area) {
    throw Refusal("its size is " + size + ", and the two together may make at most " + std::to_string(max_image_area));
  }
}

/// Refuses a picture whose decoding would take too much memory.
///
/// @param bytes  what the decoder will hold at once
/// Errors: Refusal.
inline void check_decoding_bytes(std::uint64_t bytes) {
  if (bytes <= max_decoding_bytes) return;
  throw Refusal("decoding it would take " + std::to_string((bytes >> 20) + 1) + " MiB of memory, more than " +
                std::to_string(max_decoding_bytes >> 20) +
                "; save it smaller, or with 8 bits a channel, no alpha, not interlaced and not progressive");
}

}  // namespace texmap
