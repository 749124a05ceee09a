// Chapter 04 in plain `if` and double.
#pragma once
#include <vector>

#include "04_uv_conventions/sheet.hpp"
#include "engine/app/layout_options.hpp"
#include "engine/app/lesson.hpp"
#include "engine/app/session.hpp"
#include "engine/app/texture_file.hpp"
#include "scene/paint.hpp"
#include "scene/stage.hpp"
#include "texture/checkerboard.hpp"
#include "texture/image_texture.hpp"
#include "texture/mapped.hpp"

namespace texmap::chapter_04 {

using Checkered = Mapped<RtiowMapping, Checkerboard>;
using Textured = Mapped<ConventionMapping, ImageTexture>;
using Paint = AnyOf<Solid, Checkered, Textured>;
using Object = Painted<Paint>;
enum ObjectIndex { middle, left, right, ground };  // in the order of `objects`

struct Lesson : LessonHooks {
  static constexpr About about{
      .idea = "where a picture begins on the sphere, and which way it runs",
      .changed_objects = {middle},
      .size = {1600, 796},
      .size_note = "800x600 with --convention or --rounding",
      .numbers = Numbers::only_double,
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
  TextureFile texture{"earth.png"};
  LayoutOptions layout;

  void options(CommandLine& line) override { offer(line, texture, layout); }
  void prepare(Session&) override {
    objects[middle].paint = Textured{{layout.convention}, layout.load(texture)};
  }
  void draw_all(Session& session) override { show_conventions(*this, session); }

  /// The color that one ray sees.
  Color<double> operator()(const Ray<double>& ray) const {
    return color_along(objects, ray, stage.sky, [&](const Object& object, const Hit<double>& hit) {
      LightSample<double> light = sample_light(stage.light, objects, hit);
      double brightness = surface.ambient;
      if (light.cosine > 0) brightness += surface.diffuse * light.cosine;
      return object.paint(hit) * brightness;
    });
  }
};

}  // namespace texmap::chapter_04
