// Three ways to find where a ray meets a sphere: plain, robust and hybrid.
#pragma once
#include "number/compensated.hpp"
#include "number/compiler.hpp"
#include "scene/ray.hpp"

namespace texmap {

/// How a sphere's hit points are found. To add one, name it here and in distance_to, normal_at.
enum class SphereForm {
  plain,   ///< the textbooks' b^2 - a c: good to 30 radii away in float, 1e5 in double
  robust,  ///< the line's distance from the center: to 1e4 radii in float, 1e7 in double
  hybrid,  ///< compensated and scaled: any size and length, tested to 1e7 radii in each number
};

/// The first distance ahead: the smaller positive root of a t^2 - 2 b t + c = 0; +infinity: a miss.
/// `f` is the ray's origin as seen from the sphere's center, `d` its direction, of any length.
/// Domain: 1e-6 to 30 radii away in float, 1e5 in double; fourth powers of all lengths in range.
/// Source: One Weekend 2020, Next Week.
template <class Real>
[[nodiscard]] inline Real plain_distance(const Vec3<Real>& f, const Vec3<Real>& d,
                                         const Real& radius) {
  const Real a = dot(d, d);
  const Real b = -dot(f, d);
  const Real c = dot(f, f) - square(radius);
  const Real discriminant = b * b - a * c;
  const Mask<Real> met = discriminant >= Real(0);
  if (!any(met)) return infinity<Real>();

  const Real root = sqrt(max(discriminant, Real(0)));
  const Real entry = (b - root) / a;
  const Real exit = (b + root) / a;
  const Real ahead = select(entry > Real(0), entry, select(exit > Real(0), exit, infinity<Real>()));
  return select(met, ahead, infinity<Real>());
}

/// The smaller positive root of a t^2 - 2 b t + c = 0, given root = sqrt(b^2 - a c); or +infinity.
/// Textbook: (b -+ root) / a. Here c / q and q / a with q = b +- root: no cancellation.
/// Domain: no quotient leaves the range.
/// Source: Press et al., Numerical Recipes, section 5.6.
template <class Real>
[[nodiscard]] Real root_ahead(const Real& a, const Real& b, const Real& c, const Real& root) {
  const Mask<Real> back = b < Real(0);
  const Real q = b + select(back, -root, root);
  const Mask<Real> by_c = c > Real(0) || back;
  const Real t = select(by_c, c, q) / select(by_c, q, a);
  return select(t > Real(0), t, infinity<Real>());
}

/// The first distance ahead, from the distance |f x d| / |d| of the ray's line to the center.
/// Textbook: discriminant b^2 - a c. Here the same number as a radius^2 - |f x d|^2.
/// Domain: 1e-6 to 1e4 radii away in float, 1e7 in double; fourth powers of all lengths in range.
/// Source: after Haines et al., Ray Tracing Gems (2019), chapter 7.
template <class Real>
[[nodiscard]] inline Real robust_distance(const Vec3<Real>& f, const Vec3<Real>& d,
                                          const Real& radius) {
  const Real a = dot(d, d);
  const Vec3<Real> moment = cross(f, d);
  const Real discriminant = a * square(radius) - dot(moment, moment);
  const Mask<Real> met = discriminant >= Real(0);
  if (!any(met)) return infinity<Real>();

  const Real b = -dot(f, d);
  const Real c = dot(f, f) - square(radius);
  return select(met, root_ahead(a, b, c, sqrt(max(discriminant, Real(0)))), infinity<Real>());
}

/// Where a ray meets a sphere.
template <class Real>
struct Meeting {
  Real distance;      ///< +infinity for a miss
  Vec3<Real> normal;  ///< outward, unit length; without meaning for a miss
};

/// The first hit ahead, with every digit that the number has: differences and products are kept
/// with their rounding errors, and lengths are scaled by powers of two.
/// Textbook: discriminant b^2 - a c. Domain: 1e-6 to 1e7 radii away; any finite sizes and lengths.
/// Source: this course; Kahan's determinants.
template <class Real>
[[nodiscard]] TEXMAP_NOINLINE Meeting<Real> hybrid_meeting(Vec3<Real> center, Real radius,
                                                           Ray<Real> ray) {
  const TwoParts<Real> x = two_sum(ray.origin.x, -center.x);
  const TwoParts<Real> y = two_sum(ray.origin.y, -center.y);
  const TwoParts<Real> z = two_sum(ray.origin.z, -center.z);
  const Real size = max(max(abs(x.high), max(abs(y.high), abs(z.high))), radius);
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
  const Real discriminant =
      select(far, a * square(r) - dot(moment, moment), difference_of_products(b, b, a, c));
  const Real root = sqrt(max(discriminant, Real(0)));
  const Real t = root_ahead(a, b, c, root);

  const Vec3<Real> from_foot = cross(d, moment) - d * root;  // times a
  const Vec3<Real> from_center = select(far, from_foot, f + (f_rest + d * t));
  const Mask<Real> met = discriminant >= Real(0) && a > Real(0);

  // The product of both scales can overflow if both are large or both small: one after the other.
  const Real unscale = Real(1) / scale;
  const Mask<Real> direction_up = direction_scale > Real(1);
  const Mask<Real> up = unscale > Real(1);
  const Mask<Real> same_side = (direction_up && up) || (!direction_up && !up);
  const Real distance =
      select(same_side, (t * direction_scale) * unscale, t * (direction_scale * unscale));
  return {select(met, distance, infinity<Real>()), normalize(from_center)};
}

}  // namespace texmap
