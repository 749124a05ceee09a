// An image as a smooth function of (u, v), for heights: its slope has no steps.
#pragma once
#include <array>

#include "texture/light_image.hpp"
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
/// first derivatives are continuous, also over the seam and the poles of a globe.
struct SmoothTexture {
  LightImage image;  ///< an empty one is black
  VAxis v_axis = VAxis::up;
  Wrap wrap = Wrap::spherical;  ///< needs an even number of columns

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    Color<Real> sum = gray(Real(0));
    if (image.texels.empty()) return sum;
    const Real x = uv.u * Real(image.width);
    const Real y = (v_axis == VAxis::down ? uv.v : Real(1) - uv.v) * Real(image.height);
    const Real column = floor(x);
    const Real row = floor(y);
    const std::array<Real, 3> across = smooth_weights(x - column - Real(0.5));
    const std::array<Real, 3> down = smooth_weights(y - row - Real(0.5));
    for (std::size_t j = 0; j < 3; ++j) {
      Color<Real> line = gray(Real(0));
      for (std::size_t i = 0; i < 3; ++i) {
        const auto place =
            wrapped_texel(wrap, column + Real(static_cast<double>(i) - 1),
                          row + Real(static_cast<double>(j) - 1), image.width, image.height);
        const std::array<Real, 3> texel = look_up(
            [&](int at_column, int at_row) {
              const Color<float>& c = image.at(at_column, at_row);
              return std::array{c.r, c.g, c.b};
            },
            clamp(place.column, Real(0), Real(image.width - 1)),  // a NaN becomes 0
            clamp(place.row, Real(0), Real(image.height - 1)));
        line = line + Color<Real>{texel[0], texel[1], texel[2]} * across[i];
      }
      sum = sum + line * down[j];
    }
    return sum;
  }
};

}  // namespace texmap
