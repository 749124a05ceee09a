// The seeds' own ray-sphere formulas, as they wrote them: for comparing, and for tests that show where they part.
#pragma once
#include "sphere.hpp"

namespace texmap::seeds {

/// Seed 0's first distance beyond 0.001: from b^2 - 4ac. Misses and shifts spheres from about 1000 radii away in float.
template <class Real>
[[nodiscard]] Real distance_daily(const Sphere& sphere, const Ray<Real>& ray) {
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

/// Seeds 1 and 2's first distance beyond 0.001: from h^2 - ac with half of seed 0's b, which halves the products and none of
/// the cancellation. A tangent is a miss, as in seed 1.
template <class Real>
[[nodiscard]] Real distance_half_b(const Sphere& sphere, const Ray<Real>& ray) {
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

}  // namespace texmap::seeds
