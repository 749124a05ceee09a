// What --show draws of this chapter's lesson: its mesh.
#pragma once
#include "engine/render/surfaces.hpp"
#include "lesson.hpp"

namespace texmap::chapter_08 {

/// The surface that a ray meets first.
template <class Real>
[[nodiscard]] Surface<Real> surface_along(const Lesson& lesson, const Ray<Real>& ray) {
  const MeshHit<Real> hit = first_hit(lesson.scene.mesh, ray);
  return surface_at(lesson.choice.weighted(lesson.scene.mesh, hit), lesson.paint);
}

}  // namespace texmap::chapter_08
