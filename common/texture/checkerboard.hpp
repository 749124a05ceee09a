// A checkerboard: the smallest texture that shows where (u, v) is.
#pragma once
#include "color.hpp"
#include "uv.hpp"

namespace texmap {

/// True where a whole number is even, negative ones included. No integer is made of it, so it holds for 1e12 as for 1.
///
/// Domain: any whole number, without an error; from 2^24 in float, 2^53 in double, every number is even. Errors: none;
/// infinities are even, a NaN is odd.
template <class Real>
[[nodiscard]] Mask<Real> is_even(const Real& whole) {
  const Real half = whole * Real(0.5);
  return half == floor(half);
}

/// Squares in two colors, alternating in u and in v.
struct Checkerboard {
  Rgb even;  ///< the square at (0, 0)
  Rgb odd;
  double squares = 10;  ///< along u and along v, 1 or more; an odd number puts two like squares side by side at the seam

  /// The color of the square at a place.
  ///
  /// @param uv  any numbers: beyond [0, 1) the board goes on, and a NaN counts as odd
  /// @return    one of the two colors, as number_cast gives it
  /// Domain: up to 2^22 squares in float, 2^51 in double. Bound: the right square for u and v in [0, 1), but within 1 unit
  /// roundoff of 1 from its edge; docs/numbers.md. Errors: none.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    const Real column = floor(uv.u * Real(squares));
    const Real row = floor(uv.v * Real(squares));
    return select(is_even(column + row), number_cast<Real>(even), number_cast<Real>(odd));
  }
};

}  // namespace texmap
