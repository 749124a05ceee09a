// What --show draws of this chapter's lesson: its globes, and the floor behind them.
#pragma once
#include "engine/render/surfaces.hpp"
#include "lesson.hpp"

namespace texmap::chapter_09 {

/// The surface that a ray meets first.
template <class Real>
[[nodiscard]] Surface<Real> surface_along(const Lesson& lesson, const Ray<Real>& ray) {
  const Surface<Real> nearest = surface_of(lesson.objects, ray);
  if (nearest.object >= 0) return nearest;
  const int number = static_cast<int>(lesson.objects.size());
  return surface_of(lesson.floor, lesson.ground.mapping, number, ray);
}

}  // namespace texmap::chapter_09
