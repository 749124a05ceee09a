// Three ways to find where a ray meets a sphere: the textbook's, one that keeps its digits, and one that keeps them all.
#pragma once
#include "compensated.hpp"
#include "ray.hpp"

namespace texmap {

/// How a sphere's points are found. Each costs more than the one before and holds farther; docs/numbers.md has the figures.
enum class SphereForm {
  plain,   ///< b^2 - ac of the textbooks: good to about 30 radii away in float, 1e5 in double
  robust,  ///< the distance of the line from the center, and roots without cancellation: 1e4 radii in float, 1e7 in double
  hybrid,  ///< compensated and scaled: any distance, any unit of length, any length of direction
};

/// A sphere as a ray sees it: all that its formulas need.
template <class Real>
struct SeenSphere {
  Vec3<Real> from_center;  ///< the ray's origin as seen from the sphere's center
  Vec3<Real> direction;    ///< the ray's, of any length
  Real radius;
};

/// The first distance ahead by the quadratic formula: a t^2 - 2 b t + c = 0 with discriminant b^2 - a c.
///
/// For a sphere far away b^2 and a c are alike in nearly all digits, and for an origin near the surface b and the root are.
/// Domain: sizes and direction lengths whose fourth power is in the number's range.
/// Source: seeds 1 and 2, with a bound that lifts the origin in place of their 0.001.
template <class Real>
[[nodiscard]] inline Real plain_distance(const SeenSphere<Real>& seen) {
  const Real a = dot(seen.direction, seen.direction);
  const Real b = -dot(seen.from_center, seen.direction);
  const Real c = dot(seen.from_center, seen.from_center) - square(seen.radius);
  const Real discriminant = b * b - a * c;
  const Mask<Real> met = discriminant >= Real(0);
  if (!any(met)) return infinity<Real>;

  const Real root = sqrt(larger(discriminant, Real(0)));
  const Real entry = (b - root) / a;
  const Real exit = (b + root) / a;
  const Real ahead = select(entry > Real(0), entry, select(exit > Real(0), exit, infinity<Real>));
  return select(met, ahead, infinity<Real>);
}

/// The first of the two roots of a t^2 - 2 b t + c = 0 that is ahead, +infinity if none is.
///
/// @param root  the square root of b^2 - a c, 0 or more
/// The roots are c / q and q / a with q = b +- root, whose sign makes it a sum: no like numbers are subtracted. From outside
/// (c > 0) the first is c / q; from inside it is the only one ahead. Source: Press et al., Numerical Recipes, section 5.6.
template <class Real>
[[nodiscard]] Real root_ahead(const Real& a, const Real& b, const Real& c, const Real& root) {
  const Mask<Real> back = b < Real(0);
  const Real q = b + select(back, -root, root);
  const Mask<Real> by_c = c > Real(0) || back;
  const Real t = select(by_c, c, q) / select(by_c, q, a);
  return select(t > Real(0), t, infinity<Real>);
}

/// The first distance ahead, by the distance of the ray's line from the center.
///
/// |f x d| / |d| is that distance; comparing it with the radius subtracts two lengths of the sphere's own size, where b^2 - a c
/// subtracts two squares of the distance to it. No division is done before it is known that the line meets the sphere.
/// Domain: sizes and direction lengths whose fourth power is in the number's range: 1e-9 to 1e9 in float, 1e-75 to 1e75 in
/// double. Source: the idea of Haines, Guenther and Akenine-Moller, "Precision Improvements for Ray/Sphere Intersection", Ray
/// Tracing Gems (2019), chapter 7, with Lagrange's identity in place of their projected point, which needs a division.
template <class Real>
[[nodiscard]] inline Real robust_distance(const SeenSphere<Real>& seen) {
  const Real a = dot(seen.direction, seen.direction);
  const Vec3<Real> moment = cross(seen.from_center, seen.direction);
  const Real discriminant = a * square(seen.radius) - dot(moment, moment);
  const Mask<Real> met = discriminant >= Real(0);
  if (!any(met)) return infinity<Real>;

  const Real b = -dot(seen.from_center, seen.direction);
  const Real c = dot(seen.from_center, seen.from_center) - square(seen.radius);
  return select(met, root_ahead(a, b, c, sqrt(larger(discriminant, Real(0)))), infinity<Real>);
}

/// Where a ray meets a sphere, by the form that needs both at once.
template <class Real>
struct Meeting {
  Real distance;      ///< +infinity for a miss
  Vec3<Real> normal;  ///< outward, unit length; of no meaning for a miss
};

/// The first point ahead, with every digit the number has.
///
/// All lengths are scaled by powers of two, so that nothing leaves the number's range. Far from the sphere (more than its
/// diameter or so from the center) the discriminant is that of the robust form, its cross product made of compensated
/// determinants, and the hit is reached from the line's nearest point to the center: its error is a few roundings of the
/// radius, however far the origin. Near the sphere, and inside it, b, c and b^2 - a c are compensated instead, and the hit is
/// reached along the ray.
/// Domain: any finite sizes and lengths whose ratio stays in range, and a `from_center` that is exact: a difference of two far
/// points may have been rounded before it gets here. Source: this course; determinants after Kahan.
template <class Real>
[[nodiscard]] Meeting<Real> hybrid_meeting(const SeenSphere<Real>& seen) {
  const Real scale = power_of_two_scale(larger(largest(seen.from_center), seen.radius));
  const Real direction_scale = power_of_two_scale(largest(seen.direction));
  const Vec3<Real> f = seen.from_center * scale;
  const Vec3<Real> d = seen.direction * direction_scale;
  const Real r = seen.radius * scale;

  const Real a = precise_dot(d, d);
  const Real b = -precise_dot(f, d);
  CompensatedSum<Real> power;
  power.add_product(f.x, f.x);
  power.add_product(f.y, f.y);
  power.add_product(f.z, f.z);
  power.add_product(-r, r);
  const Real c = power.value();

  const Mask<Real> far = c > square(r);
  const Vec3<Real> moment = precise_cross(f, d);
  const Real discriminant = select(far, a * square(r) - dot(moment, moment), difference_of_products(b, b, a, c));
  const Real root = sqrt(larger(discriminant, Real(0)));
  const Real t = root_ahead(a, b, c, root);

  const Vec3<Real> nearest = cross(d, moment);  // times a
  const Vec3<Real> from_center = select(far, nearest - d * root, f + d * t);
  const Mask<Real> met = discriminant >= Real(0) && a > Real(0);
  return {select(met, t * (direction_scale / scale), infinity<Real>), normalize(from_center)};
}

}  // namespace texmap
