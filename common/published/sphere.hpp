// The source documents' ray-sphere formulas as printed: to compare with, to show where they fail.
#pragma once
#include "scene/sphere.hpp"

namespace texmap::published {

/// The daily exercise's first distance beyond 0.001: from b^2 - 4ac.
///
/// Loses spheres from about 1000 radii away in float.
template <class Real>
[[nodiscard]] Real distance_daily(const Sphere<>& sphere, const Ray<Real>& ray) {
  const Vec3<Real> oc = ray.origin - number_cast<Real>(sphere.center);
  const Real a = dot(ray.direction, ray.direction);
  const Real b = Real(2) * dot(oc, ray.direction);
  const Real c = dot(oc, oc) - square(Real(sphere.radius));
  const Real discriminant = b * b - Real(4) * a * c;
  if (discriminant < Real(0)) return infinity<Real>();
  const Real root = sqrt(discriminant);
  const Real near = (-b - root) / (Real(2) * a);
  const Real far = (-b + root) / (Real(2) * a);
  return near > Real(0.001) ? near : far > Real(0.001) ? far : infinity<Real>();
}

/// The first distance beyond 0.001 in One Weekend 2020 and Next Week: from h^2 - ac with h = b / 2,
/// which cancels like b^2 - 4ac. A tangent is a miss, as in One Weekend 2020.
template <class Real>
[[nodiscard]] Real distance_half_b(const Sphere<>& sphere, const Ray<Real>& ray) {
  const Vec3<Real> oc = ray.origin - number_cast<Real>(sphere.center);
  const Real a = dot(ray.direction, ray.direction);
  const Real half_b = dot(oc, ray.direction);
  const Real c = dot(oc, oc) - square(Real(sphere.radius));
  const Real discriminant = half_b * half_b - a * c;
  if (!(discriminant > Real(0))) return infinity<Real>();
  const Real root = sqrt(discriminant);
  const Real near = (-half_b - root) / a;
  const Real far = (-half_b + root) / a;
  return near > Real(0.001) ? near : far > Real(0.001) ? far : infinity<Real>();
}

}  // namespace texmap::published
