// The triangle article's weights of a triangle's corners, from side lengths alone: to compare with
// and to show where they fail.
#pragma once
#include "math/vec3.hpp"

namespace texmap::published {

/// The area of a triangle from the lengths of its sides, by Heron's formula.
///
/// Fails on thin triangles: s - x cancels, and the error grows with the square of length / width.
/// Source: the triangle article.
template <class Real>
[[nodiscard]] Real heron_area(const Real& x, const Real& y, const Real& z) {
  const Real s = (x + y + z) / Real(2);
  return sqrt(s * (s - x) * (s - y) * (s - z));
}

/// The weights of a triangle's corners at a point; their sum is 1.
template <class Real>
struct Barycentric {
  Real a, b, c;
};

/// The corners' weights at `p`: two by Heron's areas over the whole area, the third by subtraction.
///
/// @param p  a point inside the triangle a, b, c
/// Fails outside, because areas have no sign, on thin triangles like heron_area, and on triangles
/// without an area, by a division by 0 or by a rounding error.
/// Source: the triangle article.
template <class Real>
[[nodiscard]] Barycentric<Real> barycentric_heron(const Vec3<Real>& a, const Vec3<Real>& b,
                                                  const Vec3<Real>& c, const Vec3<Real>& p) {
  const Real bc = length(c - b);
  const Real ca = length(a - c);
  const Real pa = length(a - p);
  const Real pb = length(b - p);
  const Real pc = length(c - p);
  const Real whole = heron_area(length(b - a), bc, ca);
  const Real at_a = heron_area(pb, bc, pc);
  const Real at_b = heron_area(pc, ca, pa);
  return {at_a / whole, at_b / whole, (whole - at_a - at_b) / whole};
}

}  // namespace texmap::published
