// A lesson as a first-year student writes it: stripes by `int` and `if`, in double alone.
#pragma once
#include <vector>

#include "engine/app/lesson.hpp"
#include "scene/paint.hpp"
#include "scene/stage.hpp"
#include "texture/mapped.hpp"

namespace texmap::stripes {

struct Stripes {
  Rgb first;
  Rgb second;
  int count = 8;

  Rgb operator()(const Uv<double>& uv) const {
    int stripe = static_cast<int>(uv.u * count);
    if (stripe % 2 == 0) {
      return first;
    }
    return second;
  }
};

using Striped = Mapped<RtiowMapping, Stripes>;
using Paint = AnyOf<Solid, Striped>;
using Object = Painted<Paint>;

struct Lesson : LessonHooks {
  static constexpr About about{
      .idea = "stripes in plain C++",
      .numbers = Numbers::only_double,
  };

  Stage stage;
  std::vector<Object> objects = {
      {.shape = {.center = {0, 0, 0}, .radius = 1}, .paint = Striped{{}, {red, white}}},
      {.shape = {.center = {0, -1001, 0}, .radius = 1000}, .paint = Solid{white}},
  };

  Color<double> operator()(const Ray<double>& ray) const {
    return color_along(objects, ray, stage.sky, [&](const Object& object, const Hit<double>& hit) {
      LightSample<double> light = sample_light(stage.light, objects, hit);
      double brightness = 0.2;
      if (light.cosine > 0) brightness = brightness + 0.8 * light.cosine;
      return object.paint(hit) * brightness;
    });
  }
};

}  // namespace texmap::stripes
