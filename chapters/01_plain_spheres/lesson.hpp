// The lesson of this chapter; `idea` says what it adds to the chapter before.
#pragma once
#include <vector>

#include "engine/draw/lesson.hpp"
#include "scene/paint.hpp"
#include "scene/stage.hpp"

namespace texmap::chapter_01 {

using Paint = Solid;
using Object = Painted<Paint>;
enum ObjectIndex { middle, left, right, ground };  // in the order of `objects`

struct Lesson : LessonHooks {
  static constexpr About about{
      .idea = "four plain spheres, a lamp, its shadows and a sky",
  };

  Stage stage{.light = {.position = {5, 5, 5}}, .camera = {.eye = {0, 2, 8}, .target = {0, 0, 0}}};
  Lambertian surface{.ambient = 0.2, .diffuse = 0.8};
  std::vector<Object> objects = {
      Object{.shape = {.center = {0.0, 0.0, 0.0}, .radius = 1.0}, .paint = Solid{white}},
      Object{.shape = {.center = {-2.5, 0.0, 1.0}, .radius = 0.8}, .paint = Solid{red}},
      Object{.shape = {.center = {2.5, 0.0, 1.0}, .radius = 0.8}, .paint = Solid{blue}},
      Object{.shape = {.center = {0.0, -1001.0, 0.0}, .radius = 1000.0}, .paint = Solid{white}},
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

}  // namespace texmap::chapter_01
