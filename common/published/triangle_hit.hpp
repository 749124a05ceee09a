// The usual test of a ray and a triangle, each triangle for itself.
#pragma once
#include "scene/ray.hpp"

namespace texmap::published {

/// True if a ray meets a triangle ahead of its origin.
/// Fails at edges and corners: of the triangles there, none or several may be met.
/// Source: Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection" (1997).
template <class Real>
[[nodiscard]] Mask<Real> meets_triangle(const Vec3<Real>& a, const Vec3<Real>& b,
                                        const Vec3<Real>& c, const Ray<Real>& ray) {
  const Vec3<Real> ab = b - a;
  const Vec3<Real> ac = c - a;
  const Vec3<Real> p = cross(ray.direction, ac);
  const Real inverse = Real(1) / dot(ab, p);
  const Vec3<Real> from_a = ray.origin - a;
  const Real u = dot(from_a, p) * inverse;
  const Vec3<Real> q = cross(from_a, ab);
  const Real v = dot(ray.direction, q) * inverse;
  return u >= Real(0) && v >= Real(0) && u + v <= Real(1) && dot(ac, q) * inverse > Real(0);
}

}  // namespace texmap::published
