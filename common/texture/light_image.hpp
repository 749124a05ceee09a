// An image as amounts of light.
#pragma once
#include <cstddef>

#include "math/color.hpp"
#include "texture/light_texture.hpp"

namespace texmap {

/// Amounts of light, 0 or more and linear.
using LightImage = Grid<Color<float>>;

/// The light of an image with bytes that mean `light`.
[[nodiscard]] inline LightImage light_of(const Image& image, TexelLight light) {
  const auto& levels = light_of_bytes<float>(light);
  LightImage result(image.width, image.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Rgb8& bytes = image.pixels[i];
    result.pixels[i] = {levels[bytes.r], levels[bytes.g], levels[bytes.b]};
  }
  return result;
}

}  // namespace texmap
