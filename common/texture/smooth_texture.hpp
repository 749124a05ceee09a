// An image as a smooth function of (u, v), for heights: its slope has no steps.
#pragma once
#include <array>

#include "texture/image_texture.hpp"
#include "texture/light_image.hpp"
#include "texture/uv.hpp"
#include "texture/wrap.hpp"

namespace texmap {

/// The weights of three neighboring texels in a quadratic B-spline; they sum to 1.
///
/// @param x  from the middle texel's center, in texels, -1/2 to 1/2
template <class Real>
[[nodiscard]] std::array<Real, 3> smooth_weights(const Real& x) {
  const Real half = Real(0.5);
  return {half * square(half - x), Real(0.75) - square(x), half * square(half + x)};
}

/// A mean of the nine nearest texels, weighted by a quadratic B-spline each way. The value and its
/// first derivatives are continuous: with an even number of columns also over a globe's poles.
struct SmoothTexture {
  SharedGrid<Color<float>> image;  ///< an empty one is black
  VAxis v_axis = VAxis::up;
  Wrap wrap = Wrap::spherical;  ///< needs an even number of columns
  SharedLight large{};          ///< if not empty, in place of the image: less memory, more time

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    if (!large.empty()) return mean(large, uv);
    return image.pixels.empty() ? gray(Real(0)) : mean(image, uv);
  }

 private:
  /// The mean, as the middle texel plus the others' differences from it: a constant stays exact.
  template <class Light, class Real>
  [[nodiscard]] Color<Real> mean(const Light& light, const Uv<Real>& uv) const {
    const Real x = uv.u * Real(light.width);
    const Real y = (v_axis == VAxis::down ? uv.v : Real(1) - uv.v) * Real(light.height);
    const Real column = floor(x);
    const Real row = floor(y);
    const std::array<Real, 3> across = smooth_weights(x - column - Real(0.5));
    const std::array<Real, 3> down = smooth_weights(y - row - Real(0.5));
    const Color<Real> middle = texel(light, column, row);
    Color<Real> sum = middle;
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        if (i == 0 && j == 0) continue;
        const Color<Real> other = texel(light, column + Real(i), row + Real(j));
        const Real weight =
            across[static_cast<std::size_t>(i + 1)] * down[static_cast<std::size_t>(j + 1)];
        sum = sum + (other + middle * Real(-1)) * weight;
      }
    }
    return sum;
  }

  /// The texel in a column and a row, whole numbers inside the image or beyond.
  template <class Light, class Real>
  [[nodiscard]] Color<Real> texel(const Light& light, const Real& column, const Real& row) const {
    const WrappedTexel<Real> place = wrapped_texel(wrap, column, row, light.width, light.height);
    return light_at(light, clamp(place.column, Real(0), Real(light.width - 1)),  // a NaN becomes 0
                    clamp(place.row, Real(0), Real(light.height - 1)));
  }
};

}  // namespace texmap
