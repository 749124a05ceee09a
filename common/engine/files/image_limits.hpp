// How large a picture may be. Checked before decoding: a small file cannot demand much work.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

#include "engine/files/file_error.hpp"

namespace texmap {

/// Width and height in pixels, any number that a header can hold.
struct ImageSize {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

inline constexpr std::uint32_t max_image_side = 16384;                   // pixels
inline constexpr std::uint64_t max_image_area = std::uint64_t{1} << 27;  // pixels
inline constexpr std::size_t max_file_bytes = std::size_t{64} << 20;
inline constexpr std::uint64_t max_decoding_bytes = std::uint64_t{1} << 30;

/// Refuses a picture with no pixels or too many.
inline void check_image_size(ImageSize size) {
  const auto refuse = [&](const std::string& why) {
    throw FileError("its size is " + std::to_string(size.width) + " x " +
                    std::to_string(size.height) + " pixels, " + why);
  };
  if (size.width == 0 || size.height == 0) refuse("so there is nothing to see");
  if (size.width > max_image_side || size.height > max_image_side)
    refuse("and a side may have at most " + std::to_string(max_image_side));
  if (std::uint64_t{size.width} * size.height > max_image_area)
    refuse("and the two together may make at most " + std::to_string(max_image_area));
}

/// Refuses a picture that has too many pixels for a sky.
inline void check_sky_size(ImageSize size, std::uint64_t most) {
  if (std::uint64_t{size.width} * size.height <= most) return;
  throw FileError("its size is " + std::to_string(size.width) + " x " +
                  std::to_string(size.height) + " pixels, and a sky may have at most " +
                  std::to_string(most) + "; save it smaller");
}

/// Refuses a picture that takes too much memory: `decoding` bytes at once, with file and picture,
/// and `later` for what is made of it.
void check_memory(std::uint64_t decoding, std::uint64_t later);

}  // namespace texmap
