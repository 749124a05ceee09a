// The lesson of this chapter; `idea` says what it adds to the chapter before.
#pragma once
#include <vector>

#include "engine/draw/lesson.hpp"
#include "engine/run/layout_options.hpp"
#include "engine/run/session.hpp"
#include "engine/run/texture_file.hpp"
#include "engine/run/uv_options.hpp"
#include "scene/paint.hpp"
#include "scene/stage.hpp"
#include "sheet.hpp"
#include "texture/checkerboard.hpp"
#include "texture/image_texture.hpp"
#include "texture/mapped.hpp"

namespace texmap::chapter_04 {

using Checkered = Mapped<RtiowMapping, Checkerboard>;
using Textured = Mapped<Transformed<ConventionMapping>, published::LookUpTexture>;
using Paint = AnyOf<Solid, Checkered, Textured>;
using Object = Painted<Paint>;
enum ObjectIndex { middle, left, right, ground };  // in the order of `objects`

struct Lesson : LessonHooks {
  static constexpr About about{
      .idea = "where a picture begins on the sphere, and which way it runs",
      .changed_objects = {middle},
      .size = {1600, 796},
      .size_note = "800x600 with an option that changes the globe, such as --convention",
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
  UvOptions uv;

  Groups options() override { return {texture, layout, uv}; }
  void build(Chosen&) override {
    const ConventionMapping mapping{layout.convention};
    objects[middle].paint = Textured{uv.moved(mapping), uv.read(layout.load(texture))};
  }
  void draw_all(Session& session) override { show_conventions(*this, session); }

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

}  // namespace texmap::chapter_04
