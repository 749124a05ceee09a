// A checkerboard in space: a solid texture, which needs no (u, v).
#pragma once
#include "math/vec3.hpp"
#include "texture/checkerboard.hpp"

namespace texmap {

/// 0 where `x` lies in an even cell, 1 in an odd one; cell 0 is [0, cell). NaN is odd.
/// Beyond 2^24 cells in float, 2^53 in double, every cell is even.
///
/// @param cell  above 0
template <class Real>
[[nodiscard]] Real cell_parity(const Real& x, const Real& cell) {
  return select(is_even(floor(x / cell)), Real(0), Real(1));
}

/// Cubes in two colors, alternating in x, in y and in z.
/// Domain: coordinates to 1e12. Bound: the right cube from 1 unit roundoff off its faces on, which
/// are multiples of `cell` as `Real` has it.
struct SolidCheckerboard {
  Rgb even;  ///< the cube from (0, 0, 0) to (cell, cell, cell)
  Rgb odd;
  double cell = 1;  ///< the length of a cube's edge, above 0

  /// The color at a point. Parities are added: the sum of large cell numbers would be rounded.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Vec3<Real>& p) const {
    const Real edge = Real(cell);
    const Real odd_ones = cell_parity(p.x, edge) + cell_parity(p.y, edge) + cell_parity(p.z, edge);
    return select(is_even(odd_ones), number_cast<Real>(even), number_cast<Real>(odd));
  }
};

}  // namespace texmap
