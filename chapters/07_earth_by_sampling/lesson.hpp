// The lesson of this chapter; `idea` says what it adds to the chapter before.
#pragma once
#include <vector>

#include "engine/draw/lesson.hpp"
#include "engine/run/globe_options.hpp"
#include "engine/run/layout_options.hpp"
#include "engine/run/sampling_options.hpp"
#include "engine/run/texture_file.hpp"
#include "engine/run/turntable.hpp"
#include "scene/paint.hpp"
#include "scene/path.hpp"
#include "scene/stage.hpp"
#include "texture/image_texture.hpp"
#include "texture/mapped.hpp"
#include "texture/rotated.hpp"

namespace texmap::chapter_07 {

using Textured = Mapped<Rotated<ConventionMapping>, LightTexture>;
using Object = Painted<Textured>;
enum ObjectIndex { middle };  // in the order of `objects`

struct Lesson : PathLesson {
  static constexpr About about{
      .idea = "many samples per pixel, and light that comes from everywhere",
      .size = {400, 225},
  };

  Stage stage{.camera = {.eye = {0, 1.5, 12}, .target = {0, 0, 0}, .fov_y_degrees = 24}};
  std::vector<Object> objects = {
      Object{.shape = {.center = {0.0, 0.0, 0.0}, .radius = 2.0}, .paint = {}},
  };
  TextureFile texture{"earth.png"};
  LayoutOptions layout;
  Turntable turn{.degrees = 0};
  GlobeOptions globe;

  Groups options() override { return {texture, layout, turn, sampling, globe}; }
  void build(Chosen&) override {
    objects[middle].paint = Textured{{turn.rotation(), {layout.convention}}, layout.load(texture)};
    globe.apply_to(objects, stage);  // which puts the globe on a ground
  }

  /// The color that one ray sees.
  template <class Real>
  Color<Real> operator()(const auto& scene, const PixelPlace<Real>& at, auto& random) const {
    const Ray<Real> ray = sampling.lens.ray(scene.view, at, random);
    return light_along(scene.objects, ray, scene.sky, sampling.bounces, random);
  }
};

}  // namespace texmap::chapter_07
