// Weights on a mesh in place of the exact ones: the triangle article's, and the picture's.
#pragma once
#include "published/triangle.hpp"
#include "scene/camera.hpp"
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

/// The hit with the weights of its place in the picture, as early game consoles took them. In space
/// they are wrong: a corner far from the camera weighs too much. They are right where all corners
/// are equally far. Chapter 08 shows both.
template <class Real>
[[nodiscard]] MeshHit<Real> weighted_in_picture(const Mesh& mesh, MeshHit<Real> hit,
                                                const Camera& camera) {
  if (!any(hit.met)) return hit;
  const auto eye = number_cast<Real>(camera.eye);
  const auto forward = number_cast<Real>(camera.target - camera.eye);
  const std::array<Vec3<Real>, 3> corners = corners_of(mesh, hit.triangle);
  const auto by_depth = [&](Real& weight, const Vec3<Real>& corner) {
    weight = weight * dot(corner - eye, forward);
  };
  by_depth(hit.a, corners[0]);
  by_depth(hit.b, corners[1]);
  by_depth(hit.c, corners[2]);
  const Real whole = hit.a + hit.b + hit.c;
  hit.a = hit.a / whole;
  hit.b = hit.b / whole;
  hit.c = hit.c / whole;
  return hit;
}

}  // namespace texmap::published
