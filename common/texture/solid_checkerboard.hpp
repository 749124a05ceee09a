// A checkerboard in space: cubes in two colors, cut open by whatever surface passes through them. It needs no (u, v).
#pragma once
#include "checkerboard.hpp"
#include "vec3.hpp"

namespace texmap {

/// 0 where `x` lies in an even cell of a line divided into cells, 1 where it lies in an odd one.
///
/// @param cell  the length of a cell, above 0; cell 0 goes from 0 up to `cell`, which already belongs to cell 1
/// `x` is divided, not multiplied by 1 / cell: a quotient that is a whole number comes out as that number, so that the ends of
/// cells lie where they should for every cell length. Of cells beyond 2^24 in float, 2^53 in double, all are even: so are the
/// numbers that can tell where they end. A NaN is odd.
template <class Real>
[[nodiscard]] Real cell_parity(const Real& x, const Real& cell) {
  return select(is_even(floor(x / cell)), Real(0), Real(1));
}

/// Cubes in two colors, alternating in x, in y and in z.
///
/// Bound: the right cube for every point farther than 1 u of itself from a face, for coordinates to 1e12; docs/numbers.md.
struct SolidCheckerboard {
  Rgb even;  ///< the cube from (0, 0, 0) to (cell, cell, cell)
  Rgb odd;
  double cell = 1;  ///< the length of a cube's edge, above 0

  /// The color at a point in space.
  ///
  /// The parities are added, not the numbers of the cells: of a large and a small cell number, the sum would lose the small
  /// one.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Vec3<Real>& p) const {
    const Real edge = Real(cell);
    const Real odd_ones = cell_parity(p.x, edge) + cell_parity(p.y, edge) + cell_parity(p.z, edge);
    return select(is_even(odd_ones), number_cast<Real>(even), number_cast<Real>(odd));
  }
};

}  // namespace texmap
