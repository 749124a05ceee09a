// The lesson of this chapter; `idea` says what it adds to the chapter before.
#pragma once
#include <vector>

#include "choose_scene.hpp"
#include "engine/draw/lesson.hpp"
#include "engine/run/layout_options.hpp"
#include "engine/run/texture_file.hpp"
#include "engine/run/turntable.hpp"
#include "scene/paint.hpp"
#include "scene/stage.hpp"
#include "texture/checkerboard.hpp"
#include "texture/image_texture.hpp"
#include "texture/mapped.hpp"
#include "texture/rotated.hpp"

namespace texmap::chapter_06 {

using Checkered = Mapped<RtiowMapping, Checkerboard>;
using Textured = Mapped<Rotated<ConventionMapping>, ImageTexture>;
using Paint = AnyOf<Solid, Checkered, Textured>;
using Object = Shiny<Paint>;
enum ObjectIndex { middle, left, right, ground };  // in the order of `objects`

struct Lesson : LessonHooks {
  static constexpr About about{
      .idea = "a highlight on the globe, and its picture blended with the light",
      .changed_objects = {middle},
  };

  Stage stage{.light = {.position = {5, 5, 5}}, .camera = {.eye = {0, 2, 8}, .target = {0, 0, 0}}};
  Checkered checkered{.mapping = {}, .texture = {.even = blue, .odd = white, .squares = 10}};
  std::vector<Object> objects = {
      Object{.shape = {.center = {0.0, 0.0, 0.0}, .radius = 1.0}, .paint = checkered},
      Object{.shape = {.center = {-2.5, 0.0, 1.0}, .radius = 0.8}, .paint = Solid{red}},
      Object{.shape = {.center = {2.5, 0.0, 1.0}, .radius = 0.8}, .paint = checkered},
      Object{.shape = {.center = {0.0, -1001.0, 0.0}, .radius = 1000.0}, .paint = checkered},
  };
  TextureFile texture{"earth.png"};
  LayoutOptions layout;
  Turntable turn{.degrees = 20};  // the highlight lies on the sea
  PhongOptions phong;

  Groups options() override { return {texture, layout, turn, phong}; }
  void build(Chosen& chosen) override {
    choose_scene(*this, chosen);
    objects[middle].paint = Textured{{turn.rotation(), {layout.convention}}, layout.load(texture)};
  }

  /// The color that one ray sees.
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    return color_along(objects, ray, stage.sky, [&](const Object& object, const Hit<Real>& hit) {
      const LightSample<Real> light = sample_light(stage.light, phong.casters(objects), hit);
      const Color<Real> color = object.paint(hit);
      const Real diffuse = lambert(object.material.lambertian, light);
      const Real specular = phong.highlight(object.material, light, hit.normal, -ray.direction);
      if (!object.material.blends) return color * diffuse + gray(specular);
      return mix(gray(clamp(diffuse + specular, Real(0), Real(1))), color, Real(phong.blend));
    });
  }
};

}  // namespace texmap::chapter_06
