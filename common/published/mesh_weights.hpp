// The triangle article's weights on a mesh, in place of the exact ones.
#pragma once
#include "published/triangle.hpp"
#include "scene/mesh.hpp"

namespace texmap::published {

/// The hit with the weights that Heron's formula gives, as barycentric_heron computes them.
/// Fails on thin triangles: its error grows with (length / width)^2, up to NaN.
/// Source: the triangle article.
template <class Real>
[[nodiscard]] MeshHit<Real> weighted_by_heron(const Mesh& mesh, MeshHit<Real> hit) {
  if (!any(hit.met)) return hit;
  const std::array<Vec3<Real>, 3> corners = corners_of(mesh, hit.triangle);
  const Barycentric<Real> weights =
      barycentric_heron(corners[0], corners[1], corners[2], hit.point);
  hit.a = weights.a;
  hit.b = weights.b;
  hit.c = weights.c;
  return hit;
}

}  // namespace texmap::published
