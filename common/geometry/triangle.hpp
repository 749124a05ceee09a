// A triangle, and the weights that mix what its corners carry.
#pragma once
#include "compensated.hpp"
#include "vec3.hpp"

namespace texmap {

/// A triangle of a scene. Seen from the side from which a, b, c run counterclockwise, its normal points to the viewer.
struct Triangle {
  Point a, b, c;
};

/// How much each corner of a triangle counts at a point: the point is a * corner a + b * corner b + c * corner c.
template <class Real>
struct Barycentric {
  Real a, b, c;  ///< their sum is 1; all in [0, 1] inside the triangle, one negative beyond a side, two beyond a corner
  Mask<Real> degenerate;  ///< true where there are no weights to speak of; they are (1, 0, 0) then, and never NaN
};

/// The way from one point to another without an error: each coordinate as a rounded difference and what the rounding dropped.
template <class Real>
struct ExactDifference {
  TwoParts<Real> x, y, z;

  /// The larger of the three rounded coordinates, without their signs.
  [[nodiscard]] Real size() const { return larger(abs(x.high), larger(abs(y.high), abs(z.high))); }
};

/// to - from, without an error.
///
/// Domain: as two_sum: finite, coordinates below half of the largest number. Errors: none; beyond, a part is NaN.
template <class Real>
[[nodiscard]] ExactDifference<Real> exact_difference(const Vec3<Real>& to, const Vec3<Real>& from) {
  return {two_sum(to.x, -from.x), two_sum(to.y, -from.y), two_sum(to.z, -from.z)};
}

/// Both parts scaled, without an error.
///
/// @param power_of_two  as power_of_two_scale gives it
/// Domain: no part leaves the range of normal numbers; below it, the low part loses digits. Errors: none.
template <class Real>
[[nodiscard]] TwoParts<Real> operator*(const TwoParts<Real>& a, const Real& power_of_two) {
  return {a.high * power_of_two, a.low * power_of_two};
}
/// The same for each coordinate.
template <class Real>
[[nodiscard]] ExactDifference<Real> operator*(const ExactDifference<Real>& a, const Real& power_of_two) {
  return {a.x * power_of_two, a.y * power_of_two, a.z * power_of_two};
}

/// a b - c d of numbers in two parts, rounded once but for an error of a few u^2 of |a b| + |c d|, with u the unit roundoff.
///
/// The products of two low parts are below that and left out. Swapping the two products changes the sign and nothing else.
/// Domain: as two_product.
template <class Real>
[[nodiscard]] Real difference_of_products(const TwoParts<Real>& a, const TwoParts<Real>& b, const TwoParts<Real>& c,
                                          const TwoParts<Real>& d) {
  const TwoParts<Real> ab = two_product(a.high, b.high);
  const TwoParts<Real> cd = two_product(c.high, d.high);
  const TwoParts<Real> difference = two_sum(ab.high, -cd.high);
  const Real ab_low = ab.low + (a.high * b.low + a.low * b.high);
  const Real cd_low = cd.low + (c.high * d.low + c.low * d.high);
  return difference.high + (difference.low + (ab_low - cd_low));
}

/// The vector product of two exact differences, with the error of `difference_of_products` in each coordinate.
///
/// Domain: as two_product. Errors: none; swapping the two changes the sign and nothing else.
template <class Real>
[[nodiscard]] Vec3<Real> cross(const ExactDifference<Real>& a, const ExactDifference<Real>& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

/// True where the normal of a triangle may owe its direction to rounding alone: where the corners come to lie on a line when
/// each coordinate changes by up to 2 unit roundoffs of itself, those of double where `Real` has more digits than the corners.
///
/// @param normal   cross(ab, ac)
/// @param ab, ac   the sides from a to b and from a to c
/// @param a, b, c  the corners, in the same scale as the sides
/// Domain: as two_product for the sides' coordinates, which barycentric brings to about 1. Errors: none; a NaN gives false.
template <class Real>
[[nodiscard]] Mask<Real> may_be_flat(const Vec3<Real>& normal, const ExactDifference<Real>& ab, const ExactDifference<Real>& ac,
                                     const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c) {
  const Real relative = Real(2) * larger(unit_roundoff<Real>(), Real(unit_roundoff<double>()));
  const auto grain = [&](const Real& from, const Real& to) {
    return relative * (abs(from) + abs(to));  // by how much their difference can change
  };
  const Vec3<Real> ab_grain{grain(a.x, b.x), grain(a.y, b.y), grain(a.z, b.z)};
  const Vec3<Real> ac_grain{grain(a.x, c.x), grain(a.y, c.y), grain(a.z, c.z)};

  const auto change = [](const TwoParts<Real>& left, const Real& left_grain, const TwoParts<Real>& right,
                         const Real& right_grain) {
    return left_grain * (abs(right.high) + right_grain) + abs(left.high) * right_grain;  // and their product
  };
  return abs(normal.x) <= change(ab.y, ab_grain.y, ac.z, ac_grain.z) + change(ab.z, ab_grain.z, ac.y, ac_grain.y) &&
         abs(normal.y) <= change(ab.z, ab_grain.z, ac.x, ac_grain.x) + change(ab.x, ab_grain.x, ac.z, ac_grain.z) &&
         abs(normal.z) <= change(ab.x, ab_grain.x, ac.y, ac_grain.y) + change(ab.y, ab_grain.y, ac.x, ac_grain.x);
}

/// The weights of the corners at `p`.
///
/// @param triangle  its corners become numbers of the type Real first: what a picture in float has is float corners
/// @param p         a point in the triangle's plane, inside or outside; beside the plane, the weights are those of its foot
/// @return          weights with signs; exactly (1, 0, 0), (0, 1, 0), (0, 0, 1) at the corners, and 1/2, 1/2, 0 in the middle
///                  of a side
///
/// Each weight is the area of the triangle that p forms with the other two corners, measured along the normal n so that it has
/// a sign: n . ((b - p) x (c - p)) and so on, three areas divided by their sum. Thin triangles are where areas go wrong: the
/// differences of the points round, and the two products of a 2x2 determinant cancel. Here neither loses a digit: differences
/// are kept in two parts, determinants are compensated. The error is below 3 unit roundoffs for a p inside, whatever the shape,
/// and below 10 times the square of the largest weight outside.
/// Everything is scaled by powers of two, so that sides of 1e-20 to 1e20 in float, 1e-300 to 1e300 in double, do as well as 1.
///
/// Degenerate are triangles that may be none: corners that come to lie on a line when their coordinates change by up to 2 unit
/// roundoffs of themselves. All triangles with equal corners or with corners on a line are among them, and also corners that
/// were meant to be on a line and were rounded off it, like (0, 0, 0), (0.1, 0.2, 0.3), (0.3, 0.6, 0.9): they do have weights,
/// but of a triangle that nobody drew. It costs triangles that are real but as fine as the number's own grid: at an angle to
/// the axes, those over 1e6 times longer than wide in float, 1e15 times in double; and those of size 1 that lie farther than
/// 1e6 from the origin in float, 5e14 in double. Triangles that are thin along an axis are told apart at any width. Degenerate
/// is also said of a p that is not finite, or so far outside that no digit of its weights is left. Errors: none. Domain:
/// coordinates below half of the largest number. Source: signed areas after Ericson, Real-Time Collision Detection (2005),
/// section 3.4; determinants by Kahan, see compensated.hpp; errors are measured in tests/geometry/test_triangle.cpp
/// and tests/extremes: 3 u (largest weight)^2.
template <class Real>
[[nodiscard]] Barycentric<Real> barycentric(const Triangle& triangle, const Vec3<Real>& p) {
  const Vec3<Real> a = number_cast<Real>(triangle.a);
  const Vec3<Real> b = number_cast<Real>(triangle.b);
  const Vec3<Real> c = number_cast<Real>(triangle.c);

  // The normal.
  const ExactDifference<Real> a_to_b = exact_difference(b, a);
  const ExactDifference<Real> a_to_c = exact_difference(c, a);
  const Real scale = power_of_two_scale(larger(a_to_b.size(), a_to_c.size()));
  const ExactDifference<Real> ab = a_to_b * scale;
  const ExactDifference<Real> ac = a_to_c * scale;
  const Vec3<Real> normal = cross(ab, ac);
  const Mask<Real> flat = may_be_flat(normal, ab, ac, a * scale, b * scale, c * scale);

  // Three areas along the normal. Only their ratios count, so that each factor may have a scale of its own.
  const Vec3<Real> along = normal * power_of_two_scale(largest(normal));
  const ExactDifference<Real> p_to_a = exact_difference(a, p);
  const ExactDifference<Real> p_to_b = exact_difference(b, p);
  const ExactDifference<Real> p_to_c = exact_difference(c, p);
  const Real zoom = power_of_two_scale(larger(p_to_a.size(), larger(p_to_b.size(), p_to_c.size())));
  const ExactDifference<Real> pa = p_to_a * zoom;
  const ExactDifference<Real> pb = p_to_b * zoom;
  const ExactDifference<Real> pc = p_to_c * zoom;
  const Real at_a = dot(along, cross(pb, pc));
  const Real at_b = dot(along, cross(pc, pa));
  const Real at_c = dot(along, cross(pa, pb));
  CompensatedSum<Real> areas;  // rounded once, so that halves, thirds and quarters come out as such
  areas.add(at_a);
  areas.add(at_b);
  areas.add(at_c);
  const Real sum = areas.value();

  // A NaN compares as false, so that it ends here too.
  const Mask<Real> degenerate = flat || !(sum > Real(0));
  const Real whole = select(degenerate, Real(1), sum);
  return {select(degenerate, Real(1), at_a / whole), select(degenerate, Real(0), at_b / whole),
          select(degenerate, Real(0), at_c / whole), degenerate};
}

}  // namespace texmap
