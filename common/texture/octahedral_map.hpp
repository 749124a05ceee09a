// The sphere on a square: an octahedron with its lower half folded out.
#pragma once
#include "math/circle.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// `size` with the sign of `side`: plus for 0.
template <class Real>
[[nodiscard]] Real with_sign_of(const Real& side, const Real& size) {
  return select(side < Real(0), -size, size);
}

/// From the square [-1, 1]^2 of both octahedral maps to (u, v) from 0 to 1.
template <class Real>
[[nodiscard]] Uv<Real> uv_from_square(const Real& right, const Real& up) {
  return {clamp_u(Real(0.5) + Real(0.5) * right),
          clamp(Real(0.5) + Real(0.5) * up, Real(0), Real(1))};
}

/// The octahedral map, seen from above: +y in the middle, +x right, -z up, -y in the four corners.
/// On the upper half it is a division by |x| + |y| + |z|; the lower half is mirrored at the square
/// through the middles of the four edges.
///
/// @param p  1e-15 to 1e15 long. Bound: 4 unit roundoffs of 1. Source: Cigolle et al. (2014)
template <class Real>
[[nodiscard]] Uv<Real> uv_octahedral(const Vec3<Real>& p) {
  const Real scale = Real(1) / (abs(p.x) + abs(p.y) + abs(p.z));
  const Real right = p.x * scale;
  const Real up = -p.z * scale;
  const Mask<Real> below = p.y < Real(0);
  return uv_from_square(select(below, with_sign_of(right, Real(1) - abs(up)), right),
                        select(below, with_sign_of(up, Real(1) - abs(right)), up));
}

/// The direction at (u, v) of the octahedral map, of unit length. Bound: 6 unit roundoffs.
template <class Real>
[[nodiscard]] Vec3<Real> direction_octahedral(const Uv<Real>& uv) {
  const Real right = Real(2) * uv.u - Real(1);
  const Real up = Real(2) * uv.v - Real(1);
  const Real y = Real(1) - abs(right) - abs(up);
  const Mask<Real> below = y < Real(0);
  const Real x = select(below, with_sign_of(right, Real(1) - abs(up)), right);
  const Real minus_z = select(below, with_sign_of(up, Real(1) - abs(right)), up);
  return normalize(Vec3<Real>{x, y, -minus_z});
}

/// A texel of an octahedral map.
template <class Real>
struct OctahedralTexel {
  Real column, row;  ///< whole numbers inside the image
};

/// The texel seen beyond an edge of an octahedral map, of either kind. Each edge is folded at its
/// middle: beyond it, the same edge is met upside down. Texel -1 is texel 0, not 1.
///
/// @param column, row    whole numbers from -width to 2 width - 1, -height to 2 height - 1
/// @param width, height  of the image, in texels
template <class Real>
[[nodiscard]] OctahedralTexel<Real> folded_octahedral(const Real& column, const Real& row,
                                                      int width, int height) {
  const auto folded = [](const Real& x, int n) {
    return select(x < Real(0), Real(-1) - x, select(x >= Real(n), Real(2 * n - 1) - x, x));
  };
  const Real inner_column = folded(column, width);
  const Real turned_row = select(inner_column == column, row, Real(height - 1) - row);
  const Real inner_row = folded(turned_row, height);
  return {select(inner_row == turned_row, inner_column, Real(width - 1) - inner_column), inner_row};
}

/// The equal-area octahedral map, laid out as uv_octahedral: each texel has the same solid angle.
///
/// @param p  1e-15 to 1e15 long; only its direction matters
/// Textbook: the distance from the middle is sqrt(1 - |y|). It cancels near the poles, up to 0.35
/// texel of 4096 for p rounded to float. (x^2 + z^2) / (1 + |y|) is the same and does not.
/// Bound: 0.001 texel of 4096 in float. Source: Clarberg (2008)
template <class Real>
[[nodiscard]] Uv<Real> uv_equal_area(const Vec3<Real>& p) {
  const Vec3<Real> n = normalize(p);
  const Real wide = max(abs(n.x), abs(n.z));
  const Real distance = sqrt((square(n.x) + square(n.z)) / (Real(1) + abs(n.y)));
  const Mask<Real> at_pole = !(wide > Real(0));  // there the quarter may be anything
  const Real quarter = atan2(abs(n.z), select(at_pole, Real(1), abs(n.x))) * (Real(2) / pi<Real>());
  const Real along_z = quarter * distance;
  const Real along_x = distance - along_z;
  const Mask<Real> below = n.y < Real(0);
  return uv_from_square(with_sign_of(n.x, select(below, Real(1) - along_z, along_x)),
                        with_sign_of(-n.z, select(below, Real(1) - along_x, along_z)));
}

/// The direction at (u, v) of the equal-area octahedral map. Bound: 8 unit roundoffs.
template <class Real>
[[nodiscard]] Vec3<Real> direction_equal_area(const Uv<Real>& uv) {
  const Real right = Real(2) * uv.u - Real(1);
  const Real up = Real(2) * uv.v - Real(1);
  const Real depth = Real(1) - abs(right) - abs(up);  // below 0 on the lower half
  const Real distance = max(Real(1) - abs(depth), Real(0));
  const Mask<Real> at_pole = !(distance > Real(0));
  const Real quarter =
      Real(0.5) + Real(0.5) * (abs(up) - abs(right)) / select(at_pole, Real(1), distance);
  const OnCircle<Real> around = on_circle(Real(0.25) * quarter);
  const Real radius = distance * sqrt(Real(2) - square(distance));
  return {with_sign_of(right, radius * around.cosine),
          with_sign_of(depth, Real(1) - square(distance)), with_sign_of(-up, radius * around.sine)};
}

}  // namespace texmap
