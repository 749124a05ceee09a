// An image as amounts of light.
#pragma once
#include "math/color.hpp"
#include "texture/light_texture.hpp"

namespace texmap {

/// Amounts of light, 0 or more and linear.
using LightImage = Grid<Color<float>>;

/// The light of an image with bytes that mean `light`.
[[nodiscard]] inline LightImage light_of(const Image& image, TexelLight light) {
  const auto& levels = light_of_bytes<float>(light);
  return image_of(image.width, image.height, [&](int column, int row) {
    const Rgb8& bytes = image.at(column, row);
    return Color<float>{levels[bytes.r], levels[bytes.g], levels[bytes.b]};
  });
}

/// The light of a texel inside the image.
template <class Real>
[[nodiscard]] Color<Real> light_at(const LightImage& image, const Real& column, const Real& row) {
  const std::array<Real, 3> light = look_up(
      [&](int at_column, int at_row) {
        const Color<float>& c = image.at(at_column, at_row);
        return std::array{c.r, c.g, c.b};
      },
      column, row);
  return {light[0], light[1], light[2]};
}

}  // namespace texmap
