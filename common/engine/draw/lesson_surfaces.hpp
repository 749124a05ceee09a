// The surfaces of a lesson, which --show draws in place of its light.
#pragma once
#include <type_traits>

#include "engine/draw/lesson.hpp"
#include "engine/draw/surfaces.hpp"

namespace texmap {

/// Lessons with a list of objects, each with a `shape` and a `paint`.
template <class Lesson>
concept HasObjects = requires(const Lesson& lesson) {
  lesson.objects.front().shape;
  lesson.objects.front().paint;
};

/// True for a lesson that overrides the hook `first_surface`.
template <class Lesson>
inline constexpr bool has_own_surface =
    !std::is_same_v<decltype(&Lesson::first_surface),
                    Surface<double> (LessonHooks::*)(const Ray<double>&) const>;

/// Lessons with surfaces that --show can draw.
template <class Lesson>
concept HasSurfaces = HasObjects<Lesson> || has_own_surface<Lesson>;

/// The surface that a lesson's ray meets first; by its own hook with the digits of double.
template <class Real, HasSurfaces Lesson>
[[nodiscard]] Surface<Real> surface_along(const Lesson& lesson, const Ray<Real>& ray) {
  if constexpr (!has_own_surface<Lesson>) {
    return surface_of(lesson.objects, ray);
  } else {
    const Surface<double> met =
        lesson.first_surface({number_cast<double>(ray.origin), number_cast<double>(ray.direction)});
    return {met.object, number_cast<Real>(met.normal), {Real(met.uv.u), Real(met.uv.v)}};
  }
}

/// The surfaces of a lesson as something that can be rendered, in double, whatever the number is.
template <class Lesson>
struct SurfaceColors {
  const Lesson& lesson;
  Shown shown;

  [[nodiscard]] Rgb operator()(const Ray<double>& ray) const {
    return color_of_surface(surface_along(lesson, ray), shown);
  }
};

}  // namespace texmap
