// A checkerboard: the simplest texture.
#pragma once
#include "math/color.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// True where a whole number is even, also for negative numbers; infinities are even, NaN is odd.
/// From 2^24 in float, 2^53 in double, every number is even.
template <class Real>
[[nodiscard]] Mask<Real> is_even(const Real& whole) {
  const Real half = whole * Real(0.5);
  return half == floor(half);
}

/// Squares in two colors, alternating in u and in v.
struct Checkerboard {
  Rgb even;  ///< the square at (0, 0)
  Rgb odd;
  double squares = 10;  ///< in u and in v, 1 or more; an odd number shows at the seam

  /// The color of the square that holds (u, v); v = 1 and beyond belong to the last row.
  ///
  /// @param uv  any numbers; a NaN counts as odd
  /// Domain: to 2^22 squares in float, 2^51 in double.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    const Real column = floor(uv.u * Real(squares));
    const Real row = floor(min(below_one<Real>(), uv.v) * Real(squares));
    return select(is_even(column + row), number_cast<Real>(even), number_cast<Real>(odd));
  }
};

}  // namespace texmap
