// A sphere and the points where a ray meets it.
#pragma once
#include "scene/hit.hpp"
#include "scene/sphere_forms.hpp"

namespace texmap {

/// All points at distance `radius` from `center`; none unless radius > 0. Scenes are in double.
template <class Real = double>
struct Sphere {
  using Own = Sphere;  ///< what is derived from it has its own distance_to and hit_at
  Vec3<Real> center;
  Real radius = Real(1);
  SphereForm form = SphereForm::robust;  ///< the formulas for its hit points
  [[nodiscard]] static constexpr bool convex() { return true; }  ///< see scene/shapes.hpp
};

template <class Type>
concept SphereLike = std::is_same_v<typename Type::Own, Type>;

/// 1 / radius, the same in every lane.
template <class Real, class Other>
[[nodiscard]] Real inverse_radius(const Sphere<Other>& sphere) {
  if constexpr (lanes<Real> == 1 || std::is_same_v<Real, Other>) {
    return Real(1) / number_cast<Real>(sphere.radius);
  } else {
    return Real(Scalar<Real>(1) / static_cast<Scalar<Real>>(sphere.radius));
  }
}

/// Distance along the ray to the first point of the sphere ahead, in lengths of `ray.direction`;
/// +infinity for a miss and for a direction that is zero or NaN. A tangent is a hit.
/// Domain: that of the sphere's form.
template <class Real, SphereLike Shape>
[[nodiscard]] Real distance_to(const Shape& sphere, const Ray<Real>& ray) {
  const Vec3<Real> center = number_cast<Real>(sphere.center);
  const Real radius = number_cast<Real>(sphere.radius);
  if (!(lane(sphere.radius, 0) > 0)) return infinity<Real>();
  if (sphere.form == SphereForm::plain)
    return plain_distance(ray.origin - center, ray.direction, radius);
  if (sphere.form == SphereForm::hybrid) return hybrid_meeting<Real>(center, radius, ray).distance;
  return robust_distance(ray.origin - center, ray.direction, radius);
}

/// The outward unit normal at a distance that `distance_to` returned.
/// Textbook: (point - center) / radius, the plain form. The robust form also corrects the length.
/// Source: hit points relative to the object, pbrt-v4, section 6.8.
template <class Real, SphereLike Shape>
[[nodiscard]] Vec3<Real> normal_at(const Shape& sphere, const Ray<Real>& ray,
                                   const Real& distance) {
  const Vec3<Real> center = number_cast<Real>(sphere.center);
  const Vec3<Real> along = ray.direction * distance;
  if (sphere.form == SphereForm::plain)
    return (ray.origin + along - center) * inverse_radius<Real>(sphere);
  if (sphere.form == SphereForm::hybrid)
    return hybrid_meeting<Real>(center, number_cast<Real>(sphere.radius), ray).normal;
  const Vec3<Real> normal = (ray.origin - center + along) * inverse_radius<Real>(sphere);
  // Its length to the power -1 as a series: the last term is needed from 1000 radii away in float.
  const Real squared = dot(normal, normal);
  return normal * ((Real(1.5) - Real(0.5) * squared) + Real(0.375) * square(Real(1) - squared));
}

/// The hit at a distance that `distance_to` returned.
/// Domain: radius 1e-6 to 1e6; |center| / radius up to 1e5 in float, 1e13 in double.
/// Except for plain, rays outward from `outside` miss it.
/// Source: pbrt-v4, section 6.8: a rounding bound instead of the books' fixed 0.001.
template <class Real, SphereLike Shape>
[[nodiscard]] Hit<Real> hit_at(const Shape& sphere, const Ray<Real>& ray, const Real& distance) {
  const Vec3<Real> center = number_cast<Real>(sphere.center);
  const Real radius = number_cast<Real>(sphere.radius);
  const Real u = unit_roundoff<Real>();
  const Vec3<Real> along = ray.direction * distance;
  const Vec3<Real> normal = normal_at(sphere, ray, distance);

  const Real size_from_center = largest(center) + radius;
  const Real size_along_ray = largest(ray.origin) + largest(along);
  const Vec3<Real> point =
      select(size_along_ray < size_from_center, ray.origin + along, center + normal * radius);

  const Real seen_with = size_from_center + radius;
  const Real formed_with = min(size_along_ray, size_from_center);
  const Vec3<Real> lift =
      normal * (Real(16) * u *
                (sphere.form == SphereForm::hybrid ? formed_with + u * seen_with : seen_with));
  return {normal, point, point + lift};
}

}  // namespace texmap
