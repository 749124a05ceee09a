// A triangle and its barycentric coordinates.
#pragma once
#include "math/vec3.hpp"
#include "number/compensated.hpp"

namespace texmap {

/// A triangle of a scene; its normal points to the side from which a, b, c run counterclockwise.
struct Triangle {
  Point a, b, c;
};

/// The weights of a triangle's corners at a point: p = a corner_a + b corner_b + c corner_c.
template <class Real>
struct Barycentric {
  Real a, b, c;           ///< their sum is 1; all are in [0, 1] inside the triangle
  Mask<Real> degenerate;  ///< true where the triangle has no weights; they are (1, 0, 0) then
};

/// The difference of two points without an error: each coordinate with its rounding error.
template <class Real>
struct ExactDifference {
  TwoParts<Real> x, y, z;

  /// The largest absolute value of the rounded coordinates.
  [[nodiscard]] Real size() const { return max(abs(x.high), max(abs(y.high), abs(z.high))); }
};

/// to - from, without an error. Domain: coordinates below half of the largest number.
template <class Real>
[[nodiscard]] ExactDifference<Real> exact_difference(const Vec3<Real>& to, const Vec3<Real>& from) {
  return {two_sum(to.x, -from.x), two_sum(to.y, -from.y), two_sum(to.z, -from.z)};
}

/// Both parts times a power of two, without an error.
/// Domain: the parts stay in the range of normal numbers.
template <class Real>
[[nodiscard]] TwoParts<Real> operator*(const TwoParts<Real>& a, const Real& power_of_two) {
  return {a.high * power_of_two, a.low * power_of_two};
}
/// The same for each coordinate.
template <class Real>
[[nodiscard]] ExactDifference<Real> operator*(const ExactDifference<Real>& a,
                                              const Real& power_of_two) {
  return {a.x * power_of_two, a.y * power_of_two, a.z * power_of_two};
}

/// a b - c d of numbers in two parts; swapping the products changes only the sign.
/// Domain: as two_product. Bound: one rounding and a few u^2 (|a b| + |c d|).
template <class Real>
[[nodiscard]] Real difference_of_products(const TwoParts<Real>& a, const TwoParts<Real>& b,
                                          const TwoParts<Real>& c, const TwoParts<Real>& d) {
  const TwoParts<Real> ab = two_product(a.high, b.high);
  const TwoParts<Real> cd = two_product(c.high, d.high);
  const TwoParts<Real> difference = two_sum(ab.high, -cd.high);
  const Real ab_low = ab.low + (a.high * b.low + a.low * b.high);
  const Real cd_low = cd.low + (c.high * d.low + c.low * d.high);
  return difference.high + (difference.low + (ab_low - cd_low));
}

/// The vector product of two exact differences; swapping them changes only the sign.
/// Domain and bound: as difference_of_products.
template <class Real>
[[nodiscard]] Vec3<Real> cross(const ExactDifference<Real>& a, const ExactDifference<Real>& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

/// True where the normal's direction may come from rounding alone: where moving each coordinate
/// by 2 unit roundoffs of itself (at least those of double) can bring the corners onto a line.
/// The farther out `a` is, the more it takes in beyond that: each corner is asked as `a`.
///
/// @param normal, ab, ac  cross(ab, ac) and the sides at a, of either sign
/// @param a, b, c         the corners, in the same scale
template <class Real>
[[nodiscard]] Mask<Real> may_be_flat(const Vec3<Real>& normal, const ExactDifference<Real>& ab,
                                     const ExactDifference<Real>& ac, const Vec3<Real>& a,
                                     const Vec3<Real>& b, const Vec3<Real>& c) {
  const Real relative = Real(2) * max(unit_roundoff<Real>(), Real(unit_roundoff<double>()));
  const auto grain = [&](const Real& from, const Real& to) {
    return relative * (abs(from) + abs(to));  // how much their difference can change
  };
  const Vec3<Real> ab_grain{grain(a.x, b.x), grain(a.y, b.y), grain(a.z, b.z)};
  const Vec3<Real> ac_grain{grain(a.x, c.x), grain(a.y, c.y), grain(a.z, c.z)};

  const auto change = [](const TwoParts<Real>& left, const Real& left_grain,
                         const TwoParts<Real>& right, const Real& right_grain) {
    return left_grain * (abs(right.high) + right_grain) +
           abs(left.high) * right_grain;  // and their product
  };
  return abs(normal.x) <= change(ab.y, ab_grain.y, ac.z, ac_grain.z) +
                              change(ab.z, ab_grain.z, ac.y, ac_grain.y) &&
         abs(normal.y) <= change(ab.z, ab_grain.z, ac.x, ac_grain.x) +
                              change(ab.x, ab_grain.x, ac.z, ac_grain.z) &&
         abs(normal.z) <= change(ab.x, ab_grain.x, ac.y, ac_grain.y) +
                              change(ab.y, ab_grain.y, ac.x, ac_grain.x);
}

/// True where a point comes first in the order by x, then y, then z.
[[nodiscard]] inline bool is_before(const Point& a, const Point& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// The barycentric coordinates of `p`, also outside, and the same for any order of the corners.
///
/// @param p  a point in the triangle's plane; of other points, the foot on the plane counts
/// Textbook: three signed areas, n . ((b - p) x (c - p)) and so on, divided by their sum.
/// Domain, bound: coordinates below half of the largest number; inside, 3 u (largest weight)^2.
/// Source: Ericson, Real-Time Collision Detection (2005), section 3.4; Kahan's determinants.
template <class Real>
[[nodiscard]] Barycentric<Real> barycentric(const Triangle& triangle, const Vec3<Real>& p) {
  if (is_before(triangle.b, triangle.a)) {
    const auto w = barycentric<Real>({triangle.b, triangle.a, triangle.c}, p);
    return {select(w.degenerate, w.a, w.b), select(w.degenerate, w.b, w.a), w.c, w.degenerate};
  }
  if (is_before(triangle.c, triangle.b)) {
    const auto w = barycentric<Real>({triangle.a, triangle.c, triangle.b}, p);
    return {w.a, w.c, w.b, w.degenerate};
  }
  const Vec3<Real> a = number_cast<Real>(triangle.a);
  const Vec3<Real> b = number_cast<Real>(triangle.b);
  const Vec3<Real> c = number_cast<Real>(triangle.c);

  // The normal.
  const ExactDifference<Real> a_to_b = exact_difference(b, a);
  const ExactDifference<Real> a_to_c = exact_difference(c, a);
  const Real scale = power_of_two_scale(max(a_to_b.size(), a_to_c.size()));
  const ExactDifference<Real> ab = a_to_b * scale;
  const ExactDifference<Real> ac = a_to_c * scale;
  const Vec3<Real> normal = cross(ab, ac);
  const ExactDifference<Real> bc = exact_difference(c, b) * scale;
  const Vec3<Real> corner_a = a * scale;
  const Vec3<Real> corner_b = b * scale;
  const Vec3<Real> corner_c = c * scale;
  const Mask<Real> flat = may_be_flat(normal, ab, ac, corner_a, corner_b, corner_c) ||
                          may_be_flat(normal, ab, bc, corner_b, corner_a, corner_c) ||
                          may_be_flat(normal, ac, bc, corner_c, corner_a, corner_b);

  // Three areas along the normal. Only their ratios count, so each factor has its own scale.
  const Vec3<Real> along = normal * power_of_two_scale(largest(normal));
  const ExactDifference<Real> p_to_a = exact_difference(a, p);
  const ExactDifference<Real> p_to_b = exact_difference(b, p);
  const ExactDifference<Real> p_to_c = exact_difference(c, p);
  const Real zoom = power_of_two_scale(max(p_to_a.size(), max(p_to_b.size(), p_to_c.size())));
  const ExactDifference<Real> pa = p_to_a * zoom;
  const ExactDifference<Real> pb = p_to_b * zoom;
  const ExactDifference<Real> pc = p_to_c * zoom;
  const Real at_a = dot(along, cross(pb, pc));
  const Real at_b = dot(along, cross(pc, pa));
  const Real at_c = dot(along, cross(pa, pb));
  CompensatedSum<Real> areas;  // rounded once, so that halves, thirds and quarters are exact
  areas.add(at_a);
  areas.add(at_b);
  areas.add(at_c);
  const Real sum = areas.value();

  // Written so that a NaN is degenerate.
  const Mask<Real> degenerate = flat || !(sum > Real(0));
  const Real whole = select(degenerate, Real(1), sum);
  return {select(degenerate, Real(1), at_a / whole), select(degenerate, Real(0), at_b / whole),
          select(degenerate, Real(0), at_c / whole), degenerate};
}

}  // namespace texmap
