// What --show draws of this chapter's lesson: its globe with bumps.
#pragma once
#include "engine/render/surfaces.hpp"
#include "lesson.hpp"

namespace texmap::chapter_11 {

/// The surface that a ray meets first, with the bumps' normal.
template <class Real>
[[nodiscard]] Surface<Real> surface_along(const Lesson& lesson, const Ray<Real>& ray) {
  return surface_of(lesson.objects, ray, [&](const Object& object, const Hit<Real>& hit) {
    return lesson.bumps(hit, inverse_radius<Real>(object.shape));
  });
}

}  // namespace texmap::chapter_11
