// The bytes of a picture, for exercises that find a texel among them.
#pragma once
#include <cstddef>

#include "texture/image.hpp"

namespace texmap::check {

/// Red, green and blue of each texel, row after row from the top: bytes[0] is the first one's red.
/// Beyond its ends there are zeros, so that a wrong number is a wrong color and no crash.
class Bytes {
 public:
  explicit Bytes(const Image& image) : image_(&image) {}

  int operator[](long long i) const {
    if (i < 0 || i >= 3 * static_cast<long long>(image_->pixels.size())) return 0;
    const Rgb8& texel = image_->pixels[static_cast<std::size_t>(i / 3)];
    return i % 3 == 0 ? texel.r : i % 3 == 1 ? texel.g : texel.b;
  }

 private:
  const Image* image_;
};

}  // namespace texmap::check
