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

/// A sphere made ready for the number that a picture is drawn with.
template <class Real>
struct SphereIn {
  Vec3<Real> center;
  Real radius;
  Real inverse_radius;
  SphereForm form;
};

/// 1 / radius, in the number at hand.
template <class Real>
[[nodiscard]] Real inverse_radius_in(const Sphere& sphere) {
  if constexpr (lanes<Real> == 1) {
    return Real(1) / Real(sphere.radius);
  } else {  // the same in every lane: divided once
    return Real(Scalar<Real>(1) / static_cast<Scalar<Real>>(sphere.radius));
  }
}
template <class Real>
[[nodiscard]] Real inverse_radius_in(const SphereIn<Real>& sphere) {
  return sphere.inverse_radius;
}
/// A sphere in another number, for those who meet it often. Errors: none; each number is rounded once.
template <class Real>
[[nodiscard]] SphereIn<Real> number_cast(const Sphere& sphere) {
  return {number_cast<Real>(sphere.center), Real(sphere.radius), inverse_radius_in<Real>(sphere), sphere.form};
}

/// hybrid_meeting, by copies: what a function of its own is shown must be in memory, and so would be all that it is a part of.
template <class Real>
[[nodiscard]] Meeting<Real> hybrid_meeting_of(Vec3<Real> center, Real radius, Ray<Real> ray) {
  return hybrid_meeting(center, radius, ray);
}

/// Distance along the ray to the first point of the sphere in front of it, +infinity where there is none.
///
/// @param sphere  a Sphere, or a SphereIn<Real>; here as below
/// A ray from inside meets the far side; a tangent counts as a hit. Distances are in lengths of `ray.direction`, which need not
/// be a unit vector. Errors: none; a zero or NaN direction is a miss. Domain and bounds: those of the sphere's form.
template <class Real, class AnySphere>
[[nodiscard]] Real distance_to(const AnySphere& sphere, const Ray<Real>& ray) {
  const Vec3<Real> center = number_cast<Real>(sphere.center);
  const Real radius = number_cast<Real>(sphere.radius);
  switch (sphere.form) {
    case SphereForm::plain:
      return plain_distance(ray.origin - center, ray.direction, radius);
    case SphereForm::hybrid:
      return hybrid_meeting_of(center, radius, ray).distance;
    case SphereForm::robust:
      break;
  }
  return robust_distance(ray.origin - center, ray.direction, radius);
}

/// The outward unit normal at a distance that `distance_to` gave.
///
/// It is formed from the center and never from the point in the world, but for the plain form, as the seeds do it: subtracting
/// a far center from a point near it leaves few of the digits that a texture needs. The robust form mends the length, which is
/// 1 but for roundings, by a step of Newton's instead of a square root and a division.
/// Bound, robust: 0.0015 texel distance / radius in float, 3e-12 in double; its length within 4 u, in float to 1e3 radii away.
/// Source: hit points relative to the object after pbrt-v4, section 6.8.
template <class Real, class AnySphere>
[[nodiscard]] Vec3<Real> normal_at(const AnySphere& sphere, const Ray<Real>& ray, const Real& distance) {
  const Vec3<Real> center = number_cast<Real>(sphere.center);
  const Vec3<Real> along = ray.direction * distance;
  switch (sphere.form) {
    case SphereForm::plain:
      return (ray.origin + along - center) * inverse_radius_in<Real>(sphere);
    case SphereForm::hybrid:
      return hybrid_meeting_of(center, number_cast<Real>(sphere.radius), ray).normal;
    case SphereForm::robust:
      break;
  }
  const Vec3<Real> normal = (ray.origin - center + along) * inverse_radius_in<Real>(sphere);
  return normal * (Real(1.5) - Real(0.5) * dot(normal, normal));
}

/// The hit at a distance that `distance_to` gave.
///
/// The point in the world is formed on the way that rounds less: along the ray, or from the center outward. `outside` and
/// `inside` lie off the surface by 16 times the rounding errors that the point and the next ray's look at the sphere may have:
/// a bound, where a fixed 0.001 is too much for a small sphere and too little for a large one. The hybrid form sees the next
/// ray's origin without an error, so that its bound is smaller.
/// Domain: radius 1e-6 to 1e6, |center| / radius up to 1e5 in float, 1e13 in double: beyond, the number cannot tell the
/// sphere's inside. Bound: by the robust and the hybrid form no ray from `outside` outward meets the sphere and every ray from
/// `inside` inward does; the plain form keeps neither; docs/numbers.md. Source: bounds in place of a fixed number after
/// pbrt-v4, section 6.8.
template <class Real, class AnySphere>
[[nodiscard]] Hit<Real> hit_at(const AnySphere& sphere, const Ray<Real>& ray, const Real& distance) {
  const Vec3<Real> center = number_cast<Real>(sphere.center);
  const Real radius = number_cast<Real>(sphere.radius);
  const Real u = unit_roundoff<Real>();
  const Vec3<Real> along = ray.direction * distance;
  const Vec3<Real> normal = normal_at(sphere, ray, distance);

  const Real size_from_center = largest(center) + radius;
  const Real size_along_ray = largest(ray.origin) + largest(along);
  const Vec3<Real> point = select(size_along_ray < size_from_center, ray.origin + along, center + normal * radius);

  const Real seen_with = size_from_center + radius;
  const Real formed_with = smaller(size_along_ray, size_from_center);
  const Vec3<Real> lift =
      normal * (Real(16) * u * (sphere.form == SphereForm::hybrid ? formed_with + u * seen_with : seen_with));
  return {normal, point, point + lift, point - lift, &sphere};
}

}  // namespace texmap
