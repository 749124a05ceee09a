// A sphere and the points where a ray meets it.
#pragma once
#include "hit.hpp"
#include "sphere_forms.hpp"

namespace texmap {

/// A sphere of a scene: all points at distance `radius` (> 0) from `center`.
struct Sphere {
  Point center;
  double radius = 1;
  SphereForm form = SphereForm::robust;  ///< the formulas that find its points
};

/// Distance along the ray to the first point of the sphere in front of it, +infinity where there is none.
///
/// A ray from inside meets the far side; a tangent counts as a hit. Distances are in lengths of `ray.direction`, which need not
/// be a unit vector. Errors: none; a zero or NaN direction is a miss. Domain and bounds: those of the sphere's form.
template <class Real>
[[nodiscard]] Real distance_to(const Sphere& sphere, const Ray<Real>& ray) {
  const SeenSphere<Real> seen = {ray.origin - number_cast<Real>(sphere.center), ray.direction, Real(sphere.radius)};
  switch (sphere.form) {
    case SphereForm::plain:
      return plain_distance(seen);
    case SphereForm::hybrid:
      return hybrid_meeting(seen).distance;
    case SphereForm::robust:
      break;
  }
  return robust_distance(seen);
}

/// The hit at a distance that `distance_to` gave.
///
/// The normal is formed from the center and never from the point in the world (but for the plain form, as the seeds do it):
/// subtracting a far center from a point near it would leave few of the digits that a texture needs. The point in the world is
/// formed on the way that rounds less: along the ray, or from the center outward. `outside` and `inside` are lifted by 16 unit
/// roundoffs of |center| + 2 radius, more than all roundings since could move them: a bound, where a fixed 0.001 is too much
/// for a small sphere and too little for a large one.
/// Domain: |center| / radius up to 1 / (32 unit roundoffs): beyond, the number cannot tell the sphere's inside.
/// Source: hit points relative to the object after pbrt-v4, section 6.8; the bound is measured in tests/extremes.
template <class Real>
[[nodiscard]] Hit<Real> hit_at(const Sphere& sphere, const Ray<Real>& ray, const Real& distance) {
  const Real radius = Real(sphere.radius);
  const Vec3<Real> center = number_cast<Real>(sphere.center);
  const Vec3<Real> along = ray.direction * distance;
  const Vec3<Real> normal = [&] {
    switch (sphere.form) {
      case SphereForm::plain:
        return (ray.origin + along - center) * (Real(1) / radius);
      case SphereForm::hybrid:
        return hybrid_meeting(SeenSphere<Real>{ray.origin - center, ray.direction, radius}).normal;
      case SphereForm::robust:
        break;
    }
    const Vec3<Real> n = (ray.origin - center + along) * (Real(1) / radius);
    return n * (Real(1.5) - Real(0.5) * dot(n, n));
  }();

  const Real size_from_center = largest(center) + radius;
  const Real size_along_ray = largest(ray.origin) + largest(along);
  const Vec3<Real> point = select(size_along_ray < size_from_center, ray.origin + along, center + normal * radius);

  const Real lift = Real(16) * unit_roundoff<Real> * (size_from_center + radius);
  return {normal, point, center + normal * (radius + lift), center + normal * (radius - lift)};
}

}  // namespace texmap
