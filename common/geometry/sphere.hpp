// A sphere and the points where a ray meets it.
#pragma once
#include "ray.hpp"

namespace texmap {

/// A sphere of a scene: all points at distance `radius` (> 0) from `center`.
struct Sphere {
  Point center;
  double radius = 1;
};

/// Where a ray meets a sphere.
template <class Real>
struct Hit {
  Vec3<Real> normal;   ///< outward, unit length; times the radius it is the hit point as seen from the sphere's center
  Vec3<Real> point;    ///< the hit point in the world
  Vec3<Real> leaving;  ///< the hit point lifted off the surface, so far that rounding cannot have left it inside
};

/// Distance along the ray to the first point of the sphere in front of it, +infinity where there is none.
///
/// A ray from inside meets the far side; a tangent counts as a hit. Distances are in lengths of `ray.direction`, which need not
/// be a unit vector.
/// The discriminant is r^2 minus the squared distance of the line from the center, not b^2 - 4ac, whose two terms are equal in
/// all digits for a sphere far away; the two roots are c / q and q / a, of which neither subtracts like numbers.
/// Errors: none; a zero or NaN direction is a miss.
/// Source: Haines, Guenther and Akenine-Moller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems
/// (2019), chapter 7; roots after Press et al., Numerical Recipes, section 5.6.
template <class Real>
[[nodiscard]] Real distance_to(const Sphere& sphere, const Ray<Real>& ray) {
  const Real radius = Real(sphere.radius);
  const Vec3<Real> from_center = ray.origin - number_cast<Real>(sphere.center);

  // The point of the line that is nearest to the center, and how far inside the sphere it lies.
  const Real a = dot(ray.direction, ray.direction);
  const Real b = -dot(from_center, ray.direction);
  const Vec3<Real> nearest = from_center + ray.direction * (b / a);
  const Real discriminant = square(radius) - dot(nearest, nearest);
  const Mask<Real> met = discriminant >= Real(0);
  if (!any(met)) return infinity<Real>;

  // The two roots of a t^2 - 2 b t + c = 0.
  const Real root = sqrt(a * larger(discriminant, Real(0)));
  const Real q = b + select(b < Real(0), -root, root);
  const Real from = length(from_center);
  const Real c = (from - radius) * (from + radius);
  const Real one = c / q;
  const Real other = q / a;
  const Real entry = smaller(one, other);
  const Real exit = larger(one, other);

  const Real ahead = select(entry > Real(0), entry, select(exit > Real(0), exit, infinity<Real>));
  return select(met, ahead, infinity<Real>);
}

/// The hit at a distance that `distance_to` gave.
///
/// The normal is formed from the center and never from the point in the world: subtracting a far center from a point near it
/// would leave few of the digits that a texture needs. The point in the world is formed on the way that rounds less: along the
/// ray, or from the center outward. `leaving` is lifted by 16 unit roundoffs of |center| + 2 radius, more than all roundings
/// since could move it: a bound, where a fixed 0.001 is too much for a small sphere and too little for a large one.
/// Source: hit points relative to the object after pbrt-v4, section 6.8; the bound is measured in
/// tests/geometry/test_sphere.cpp.
template <class Real>
[[nodiscard]] Hit<Real> hit_at(const Sphere& sphere, const Ray<Real>& ray, const Real& distance) {
  const Real radius = Real(sphere.radius);
  const Vec3<Real> center = number_cast<Real>(sphere.center);
  const Vec3<Real> along = ray.direction * distance;
  const Vec3<Real> normal = normalize(ray.origin - center + along);

  const Real size_from_center = largest(center) + radius;
  const Real size_along_ray = largest(ray.origin) + largest(along);
  const Vec3<Real> point = select(size_along_ray < size_from_center, ray.origin + along, center + normal * radius);

  const Real lift = Real(16) * unit_roundoff<Real> * (size_from_center + radius);
  return {normal, point, center + normal * (radius + lift)};
}

}  // namespace texmap
