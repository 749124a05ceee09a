// The size of a picture that is not decoded yet.
#pragma once
#include <cstdint>

namespace texmap {

/// Width and height as a file states them.
struct ImageSize {
  std::uint32_t width = 0;   // pixels
  std::uint32_t height = 0;  // pixels
  friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

}  // namespace texmap
