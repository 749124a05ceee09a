// A checkerboard: the smallest texture that shows where (u, v) is.
#pragma once
#include "color.hpp"
#include "uv.hpp"

namespace texmap {

/// True where a whole number is even, negative ones included. No integer is made of it, so it holds for 1e12 as for 1.
/// Domain: any whole number, without an error; from 2^24 in float, 2^53 in double, every number is even.
template <class Real>
[[nodiscard]] Mask<Real> is_even(const Real& whole) {
  const Real half = whole * Real(0.5);
  return half == floor(half);
}

/// Squares in two colors, alternating in u and in v.
///
/// Bound: the right square for u and v in [0, 1), but within 1 unit roundoff of 1 from its edge; docs/numbers.md.
struct Checkerboard {
  Rgb even;  ///< the square at (0, 0)
  Rgb odd;
  double squares = 10;  ///< along u and along v; an odd number puts two like squares side by side at the seam

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    const Real column = floor(uv.u * Real(squares));
    const Real row = floor(uv.v * Real(squares));
    return select(is_even(column + row), number_cast<Real>(even), number_cast<Real>(odd));
  }
};

}  // namespace texmap
