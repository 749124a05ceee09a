// An image as amounts of light.
#pragma once
#include <cstddef>
#include <utility>

#include "math/color.hpp"
#include "number/compiler.hpp"
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

/// The light of an image in the numbers of its file, which copies share: bytes, 16 bits or
/// floats.
class SharedLight {
 public:
  int width = 0;
  int height = 0;

  SharedLight() = default;
  SharedLight(LightImage image) : SharedLight(SharedGrid(std::move(image))) {}
  SharedLight(SharedGrid<Color<float>> fine)
      : width(fine.width), height(fine.height), fine_(std::move(fine)) {}
  SharedLight(SharedGrid<Rgb16> deep)  ///< each channel / 65535
      : width(deep.width), height(deep.height), deep_(std::move(deep)) {}
  SharedLight(SharedImage image, TexelLight light)
      : width(image.width),
        height(image.height),
        bytes_(std::move(image)),
        levels_(light_of_bytes<float>(light).data()) {}

  [[nodiscard]] bool empty() const { return width == 0 || height == 0; }
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  /// The light of texel number `texel`, counted row by row.
  [[nodiscard]] Color<float> operator[](std::size_t texel) const {
    if (levels_ == nullptr) return without_bytes(texel);
    const Rgb8& at = bytes_.pixels[texel];
    return {levels_[at.r], levels_[at.g], levels_[at.b]};
  }
  [[nodiscard]] Color<float> at(int column, int row) const {
    return (*this)[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(column)];
  }

 private:
  [[nodiscard]] TEXMAP_NOINLINE Color<float> without_bytes(std::size_t texel) const {
    if (deep_.pixels.empty()) return fine_.pixels[texel];
    const auto light = [](std::uint16_t channel) { return static_cast<float>(channel) / 65535; };
    const Rgb16& at = deep_.pixels[texel];
    return {light(at.r), light(at.g), light(at.b)};
  }

  SharedImage bytes_;
  const float* levels_ = nullptr;
  SharedGrid<Color<float>> fine_;
  SharedGrid<Rgb16> deep_;
};

/// The light of a texel inside the image; a LightImage or a SharedLight.
template <class Light, class Real>
[[nodiscard]] Color<Real> light_at(const Light& image, const Real& column, const Real& row) {
  const std::array<Real, 3> light = look_up(
      [&](int at_column, int at_row) {
        const Color<float> c = image.at(at_column, at_row);
        return std::array{c.r, c.g, c.b};
      },
      column, row);
  return {light[0], light[1], light[2]};
}

}  // namespace texmap
