// An image as amounts of light.
#pragma once
#include <cstddef>
#include <vector>

#include "math/color.hpp"
#include "texture/image_texture.hpp"

namespace texmap {

/// Amounts of light, 0 or more and linear, row by row from the top, each row from the left.
struct LightImage {
  int width = 0;
  int height = 0;
  std::vector<Color<float>> texels;

  LightImage() = default;
  LightImage(int columns, int rows, const Color<float>& fill = {})
      : width(columns),
        height(rows),
        texels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), fill) {}

  /// The texel in a column and a row, both from 0, rows from the top; not checked.
  [[nodiscard]] Color<float>& at(int column, int row) { return texels[place(column, row)]; }
  [[nodiscard]] const Color<float>& at(int column, int row) const {
    return texels[place(column, row)];
  }

 private:
  [[nodiscard]] std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }
};

/// The light of an image with bytes that mean `light`.
[[nodiscard]] inline LightImage light_of(const Image& image, TexelLight light) {
  const auto& levels = light_of_bytes<float>(light);
  LightImage result(image.width, image.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Rgb8& bytes = image.pixels[i];
    result.texels[i] = {levels[bytes.r], levels[bytes.g], levels[bytes.b]};
  }
  return result;
}

}  // namespace texmap
