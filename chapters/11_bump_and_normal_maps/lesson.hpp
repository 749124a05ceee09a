// The lesson of this chapter; `idea` says what it adds to the chapter before.
#pragma once
#include <vector>

#include "engine/draw/lesson.hpp"
#include "engine/run/bump_options.hpp"
#include "engine/run/layout_options.hpp"
#include "engine/run/texture_file.hpp"
#include "engine/run/turntable.hpp"
#include "heights.hpp"
#include "scene/paint.hpp"
#include "scene/shading_normal.hpp"
#include "scene/stage.hpp"
#include "sheets.hpp"
#include "texture/image_texture.hpp"
#include "texture/mapped.hpp"
#include "texture/rotated.hpp"
#include "texture/surface.hpp"

namespace texmap::chapter_11 {

using Textured = Mapped<Rotated<ConventionMapping>, ImageTexture>;
using Paint = AnyOf<Solid, Textured>;
using Object = Painted<Paint>;
enum ObjectIndex { middle };  // in the order of `objects`

struct Lesson : LessonHooks {
  static constexpr About about{
      .idea = "bumps: a normal that leans downhill, from a height",
      .size = {600, 600},
      .size_note = "1600 wide with --show sheet, 1000 with poles and daily",
  };

  Stage stage{
      .light = {.position = {-10, 8, 8}},
      .sky = {.below = {0.02, 0.02, 0.03}, .above = {0.02, 0.02, 0.03}},
      .camera = {.eye = {0, 0, 6}, .target = {0, 0, 0}, .fov_y_degrees = 20},
  };
  Lambertian surface{.ambient = 0.12, .diffuse = 0.88};
  std::vector<Object> objects = {
      Object{.shape = {.center = {0.0, 0.0, 0.0}, .radius = 1.0}, .paint = Solid{white}},
  };
  TextureFile texture{"earth.png"};
  LayoutOptions layout;
  Turntable turn{.degrees = 170};
  BumpOptions bump;
  GlobeBumps bumps;

  Groups options() override { return {texture, layout, turn, bump}; }
  void build(Chosen& chosen) override {
    bump.check(chosen);
    bumps = make_bumps(bump, {turn.rotation(), {layout.convention}});
    if (!bump.paints(chosen)) return;  // white
    objects[middle].paint = Textured{{turn.rotation(), {layout.convention}}, layout.load(texture)};
  }
  Surface<double> first_surface(const Ray<double>& ray) const override {
    return surface_of(objects, ray, bumps);
  }
  void draw_all(Session& session) override { show_bumps(*this, session); }

  /// The color that one ray sees.
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    return color_along(objects, ray, stage.sky, [&](const Object& object, const Hit<Real>& hit) {
      const Vec3<Real> normal = bumps(object, hit);
      const LightSample<Real> light = sample_light(stage.light, objects, hit, normal);
      const Color<Real> color = object.paint(hit);
      return color * lambert(surface, light);
    });
  }
};

}  // namespace texmap::chapter_11
