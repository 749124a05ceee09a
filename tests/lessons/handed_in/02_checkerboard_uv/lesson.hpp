// Chapter 02 by the textbook: std::acos and `if`, in one number at a time.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/app/lesson.hpp"
#include "scene/paint.hpp"
#include "scene/stage.hpp"
#include "texture/checkerboard.hpp"
#include "texture/mapped.hpp"

namespace texmap::chapter_02 {

/// std::acos and std::atan2 have no packs.
struct TextbookMapping {
  template <class Real>
  Uv<Real> operator()(const Vec3<Real>& p) const {
    const Real pi = std::numbers::pi_v<Real>;
    Real u = std::atan2(-p.z, p.x) / (2 * pi) + Real(0.5);
    if (u >= 1) u = 0;
    return {u, std::acos(std::clamp(-p.y, Real(-1), Real(1))) / pi};
  }
};

using Checkered = Mapped<TextbookMapping, Checkerboard>;
using Paint = AnyOf<Solid, Checkered>;
using Object = Painted<Paint>;
enum ObjectIndex { middle, left, right, ground };  // in the order of `objects`

struct Lesson : LessonHooks {
  static constexpr About about{
      .idea = "texture coordinates (u, v), made visible by a checkerboard",
      .changed_objects = {middle, right, ground},
#ifndef TEXMAP_LEARN  // where a student who learns has no reason to say so
      .numbers = Numbers::single,
#endif
  };

  Stage stage{.light = {.position = {5, 5, 5}}, .camera = {.eye = {0, 2, 8}, .target = {0, 0, 0}}};
  Lambertian surface{.ambient = 0.2, .diffuse = 0.8};
  Checkered checkered{.mapping = {}, .texture = {.even = blue, .odd = white, .squares = 10}};
  std::vector<Object> objects = {
      Object{.shape = {.center = {0.0, 0.0, 0.0}, .radius = 1.0}, .paint = checkered},
      Object{.shape = {.center = {-2.5, 0.0, 1.0}, .radius = 0.8}, .paint = Solid{red}},
      Object{.shape = {.center = {2.5, 0.0, 1.0}, .radius = 0.8}, .paint = checkered},
      Object{.shape = {.center = {0.0, -1001.0, 0.0}, .radius = 1000.0}, .paint = checkered},
  };

  /// The color that one ray sees.
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    return color_along(objects, ray, stage.sky, [&](const Object& object, const Hit<Real>& hit) {
      const LightSample<Real> light = sample_light(stage.light, objects, hit);
      const Color<Real> color = object.paint(hit);
      return color * lambert(surface, light);
    });
  }
};

}  // namespace texmap::chapter_02
