// Three ways to find where a ray meets a sphere: the textbook's, one that keeps its digits, and one that keeps them all.
#pragma once
#include "compensated.hpp"
#include "compiler.hpp"
#include "ray.hpp"

namespace texmap {

/// How a sphere's points are found. Each costs more than the one before and holds farther; docs/numbers.md has the figures.
enum class SphereForm {
  plain,   ///< b^2 - ac of the textbooks: good to about 30 radii away in float, 1e5 in double
  robust,  ///< the distance of the line from the center, and roots without cancellation: 1e4 radii in float, 1e7 in double
  hybrid,  ///< compensated and scaled: any distance, any unit of length, any length of direction
};

/// The first distance ahead by the quadratic formula: a t^2 - 2 b t + c = 0 with discriminant b^2 - a c; +infinity for a miss.
///
/// @param f       the ray's origin as seen from the sphere's center
/// @param d       the ray's direction, of any length
/// @param radius  the sphere's
/// For a sphere far away b^2 and a c are alike in nearly all digits, and for an origin near the surface b and the root are.
/// Domain: 1e-6 to 30 radii away in float, 1e5 in double; sizes and direction lengths whose fourth power is in range.
/// Bound: a ray is misjudged only within 3 u (distance / radius)^2 of grazing, with u the unit roundoff; docs/numbers.md.
/// Source: seeds 1 and 2, with a bound that lifts the origin in place of their 0.001.
template <class Real>
[[nodiscard]] inline Real plain_distance(const Vec3<Real>& f, const Vec3<Real>& d, const Real& radius) {
  const Real a = dot(d, d);
  const Real b = -dot(f, d);
  const Real c = dot(f, f) - square(radius);
  const Real discriminant = b * b - a * c;
  const Mask<Real> met = discriminant >= Real(0);
  if (!any(met)) return infinity<Real>();

  const Real root = sqrt(larger(discriminant, Real(0)));
  const Real entry = (b - root) / a;
  const Real exit = (b + root) / a;
  const Real ahead = select(entry > Real(0), entry, select(exit > Real(0), exit, infinity<Real>()));
  return select(met, ahead, infinity<Real>());
}

/// The first of the two roots of a t^2 - 2 b t + c = 0 that is ahead, +infinity if none is.
///
/// @param a     above 0
/// @param c     above 0 where the ray starts outside the sphere, 0 on it, below inside
/// @param root  the square root of b^2 - a c, 0 or more
/// Domain: no quotient leaves the range. Bound: 2 u of the root that the four numbers have, for the sum q and the quotient;
/// what they lost before they came here is each form's matter. Errors: none; a NaN, and a direction without a length (a = b =
/// 0), is a miss. The roots are c / q and q / a with q = b +- root, whose sign makes it a sum: no like numbers are subtracted.
/// From outside (c > 0) the first is c / q; from inside it is the only one ahead. Source: Press et al., Numerical Recipes,
/// section 5.6.
template <class Real>
[[nodiscard]] Real root_ahead(const Real& a, const Real& b, const Real& c, const Real& root) {
  const Mask<Real> back = b < Real(0);
  const Real q = b + select(back, -root, root);
  const Mask<Real> by_c = c > Real(0) || back;
  const Real t = select(by_c, c, q) / select(by_c, q, a);
  return select(t > Real(0), t, infinity<Real>());
}

/// The first distance ahead, by the distance of the ray's line from the center; +infinity for a miss.
///
/// @param f, d, radius  as for plain_distance
/// |f x d| / |d| is that distance; comparing it with the radius subtracts two lengths of the sphere's own size, where b^2 - a c
/// subtracts two squares of the distance to it. No division is done before it is known that the line meets the sphere.
/// Domain: 1e-6 to 1e4 radii away in float, 1e7 in double; sizes and direction lengths whose fourth power is in range, 1e-4 to
/// 1e4 in float, 1e-66 to 1e66 in double. Bound: a ray is misjudged only within 3 u distance / radius of grazing; the distance
/// is within 16 ulp of itself or the radius, for rays that pass the center within 0.99 radii; docs/numbers.md. Source: the idea
/// of Haines, Guenther and Akenine-Moller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019),
/// chapter 7, with Lagrange's identity in place of their projected point, which needs a division.
template <class Real>
[[nodiscard]] inline Real robust_distance(const Vec3<Real>& f, const Vec3<Real>& d, const Real& radius) {
  const Real a = dot(d, d);
  const Vec3<Real> moment = cross(f, d);
  const Real discriminant = a * square(radius) - dot(moment, moment);
  const Mask<Real> met = discriminant >= Real(0);
  if (!any(met)) return infinity<Real>();

  const Real b = -dot(f, d);
  const Real c = dot(f, f) - square(radius);
  return select(met, root_ahead(a, b, c, sqrt(larger(discriminant, Real(0)))), infinity<Real>());
}

/// Where a ray meets a sphere, by the form that needs both at once.
template <class Real>
struct Meeting {
  Real distance;      ///< +infinity for a miss
  Vec3<Real> normal;  ///< outward, unit length; of no meaning for a miss
};

/// The first point ahead, with every digit the number has.
///
/// The way from the center to the origin is kept without an error, in two parts: an origin close above a large or far sphere
/// knows its height. All lengths are scaled by powers of two, so that nothing leaves the number's range. Far from the sphere
/// (more than 1.4 radii from the center) the discriminant is that of the robust form, its cross product made of compensated
/// determinants, and the hit is reached from the line's nearest point to the center: its error is a few roundings of the
/// radius, however far the origin. Near the sphere, and inside it, b, c and b^2 - a c are compensated instead, and the hit is
/// reached along the ray.
/// Domain: 1e-6 to 1e7 radii away and any finite sizes and lengths, as long as the answer is in range. Bound: a ray is
/// misjudged only within 3 u of grazing, which is 2e-7 of the radius in float and 4e-16 in double, at any distance; else the
/// distance is within 6 ulp and the normal within 0.0015 texel of 8192 by 4096 in float, 3e-12 in double; docs/numbers.md. It
/// takes some 20 times as long as the plain form, alone, and 6 times in a whole picture. Source: this course; determinants
/// after Kahan. Not inlined: it is long, and loops that could call it, but do not, would be slower for it.
template <class Real>
[[nodiscard]] TEXMAP_NOINLINE Meeting<Real> hybrid_meeting(const Vec3<Real>& center, const Real& radius, const Ray<Real>& ray) {
  const TwoParts<Real> x = two_sum(ray.origin.x, -center.x);
  const TwoParts<Real> y = two_sum(ray.origin.y, -center.y);
  const TwoParts<Real> z = two_sum(ray.origin.z, -center.z);
  const Real size = larger(larger(abs(x.high), larger(abs(y.high), abs(z.high))), radius);
  const Real scale = power_of_two_scale(size);
  const Real direction_scale = power_of_two_scale(largest(ray.direction));
  const Vec3<Real> f = Vec3<Real>{x.high, y.high, z.high} * scale;
  const Vec3<Real> f_rest = Vec3<Real>{x.low, y.low, z.low} * scale;
  const Vec3<Real> d = ray.direction * direction_scale;
  const Real r = radius * scale;

  const Real a = precise_dot(d, d);
  const Real b = -precise_dot(f, d, dot(f_rest, d));
  CompensatedSum<Real> power;
  power.add_product(f.x, f.x);
  power.add_product(f.y, f.y);
  power.add_product(f.z, f.z);
  power.add_product(-r, r);
  power.add(Real(2) * dot(f, f_rest));
  const Real c = power.value();

  const Mask<Real> far = c > square(r);
  const Vec3<Real> moment = precise_cross(f, d) + cross(f_rest, d);
  const Real discriminant = select(far, a * square(r) - dot(moment, moment), difference_of_products(b, b, a, c));
  const Real root = sqrt(larger(discriminant, Real(0)));
  const Real t = root_ahead(a, b, c, root);

  const Vec3<Real> from_foot = cross(d, moment) - d * root;  // times a
  const Vec3<Real> from_center = select(far, from_foot, f + (f_rest + d * t));
  const Mask<Real> met = discriminant >= Real(0) && a > Real(0);

  // Two powers of two, of which one alone may leave the range: if both are large or both small, one after the other.
  const Real unscale = Real(1) / scale;
  const Mask<Real> direction_up = direction_scale > Real(1);
  const Mask<Real> up = unscale > Real(1);
  const Mask<Real> alike = (direction_up && up) || (!direction_up && !up);
  const Real distance = select(alike, (t * direction_scale) * unscale, t * (direction_scale * unscale));
  return {select(met, distance, infinity<Real>()), normalize(from_center)};
}

}  // namespace texmap
