// Seed 3's weights of a triangle's corners, from side lengths alone: for comparing, and for tests that show where they fail.
#pragma once
#include <utility>

#include "triangle.hpp"

namespace texmap::seeds {

/// The area of a triangle from the lengths of its sides, by Heron's formula as every table prints it.
///
/// Fails on thin triangles: s - x subtracts like numbers, so that the error grows in proportion to how much longer than wide
/// the triangle is, until no digit is left, or the root is that of a negative number and the area NaN. Source: seed 3.
template <class Real>
[[nodiscard]] Real heron_area(const Real& x, const Real& y, const Real& z) {
  const Real s = (x + y + z) / Real(2);
  return sqrt(s * (s - x) * (s - y) * (s - z));
}

/// The area of a triangle from the lengths of its sides, right to a few units in the last place for lengths without an error.
///
/// Where it fails: lengths that come from points have been rounded, and rounding may have left no triangle: a longest side that
/// exceeds the other two together gives NaN. A sliver loses its area when its sides are rounded, and no formula brings it back.
/// Source: Kahan, "Miscalculating Area and Angles of a Needle-like Triangle" (2014); the bound, below 5 unit roundoffs, by
/// Boldo, "How to Compute the Area of a Triangle: a Formal Revisit" (2013).
template <class Real>
[[nodiscard]] Real heron_area_kahan(Real x, Real y, Real z) {
  if (x < y) std::swap(x, y);
  if (y < z) std::swap(y, z);
  if (x < y) std::swap(x, y);
  return sqrt((x + (y + z)) * (z - (x - y)) * (z + (x - y)) * (x + (y - z))) / Real(4);
}

/// The corners' weights at `p` as seed 3 finds them: the areas of the triangles opposite a and b by Heron's formula, each
/// divided by the whole area, and the third by subtraction.
///
/// @param p  a point inside the triangle; for single numbers only, not for packs
/// Fails outside: areas have no sign, so that a point beyond a side is taken for one inside, and the third weight becomes
/// negative instead of the right one. Fails on thin triangles, as heron_area does. Fails on triangles without an area: a
/// division by 0, or by a rounding error. `degenerate` is never set: the seed does not look. Source: seed 3.
template <class Real>
[[nodiscard]] Barycentric<Real> barycentric_heron(const Triangle& triangle, const Vec3<Real>& p) {
  const Vec3<Real> a = number_cast<Real>(triangle.a);
  const Vec3<Real> b = number_cast<Real>(triangle.b);
  const Vec3<Real> c = number_cast<Real>(triangle.c);
  const Real ab = length(b - a);
  const Real bc = length(c - b);
  const Real ca = length(a - c);
  const Real pa = length(a - p);
  const Real pb = length(b - p);
  const Real pc = length(c - p);

  const Real whole = heron_area(ab, bc, ca);
  const Real at_a = heron_area(pb, bc, pc);
  const Real at_b = heron_area(pc, ca, pa);
  return {at_a / whole, at_b / whole, (whole - at_a - at_b) / whole, false};
}

}  // namespace texmap::seeds
