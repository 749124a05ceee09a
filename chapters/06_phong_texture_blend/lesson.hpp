// The lesson of this chapter; `idea` says what it adds to the chapter before.
#pragma once
#include <array>
#include <vector>

#include "checkerboard.hpp"
#include "conventions.hpp"
#include "image_texture.hpp"
#include "layout_options.hpp"
#include "lecture_scene.hpp"
#include "mapped.hpp"
#include "painted.hpp"
#include "phong.hpp"
#include "phong_options.hpp"
#include "rotated.hpp"
#include "rotation_options.hpp"
#include "solid.hpp"
#include "stage.hpp"
#include "studio.hpp"
#include "texture_file.hpp"

namespace texmap::chapter_06 {

using Checkered = Mapped<RtiowMapping, Checkerboard>;
using Textured = Mapped<Rotated<ConventionMapping>, ImageTexture>;
using Paint = AnyOf<Solid, Checkered, Textured>;
using Object = Glossy<Paint>;
enum ObjectIndex { middle, left, right, ground };

struct Lesson {
  static constexpr const char* idea = "a highlight on the globe, and its picture blended with the light";
  static constexpr std::array changed_objects = {middle};

  Stage stage{.light = {.position = {5, 5, 5}}, .camera = {.eye = {0, 2, 8}, .target = {0, 0, 0}}};
  Solid white{{0.9, 0.9, 0.9}};
  Solid blue{{0.2, 0.2, 0.8}};
  Solid red{{1.0, 0.3, 0.3}};
  Checkered checkered{{}, {.even = blue.color, .odd = white.color, .squares = 10}};
  std::vector<Object> objects = {
      {{{0.0, 0.0, 0.0}, 1.0}, checkered},
      {{{-2.5, 0.0, 1.0}, 0.8}, red},
      {{{2.5, 0.0, 1.0}, 0.8}, checkered},
      {{{0.0, -1001.0, 0.0}, 1000.0}, checkered},
  };
  TextureFile texture{"earth.png"};
  LayoutOptions layout;
  RotationOptions turn;
  PhongOptions phong;

  void options(CommandLine& line) {
    texture.declare(line);
    layout.declare(line);
    turn.declare(line);
    phong.declare(line);
  }
  void prepare(Studio& studio) {
    if (phong.settle(studio) == PhongScene::lecture) set_lecture_scene(*this, studio);
    objects[middle].paint = Textured{{rotation_y(turn.degrees), {layout.convention}}, layout.lay_out(texture)};
    phong.polish(objects[middle].finish);
  }
  void show(Studio& studio) {
    if (turn.frames == 0) return studio.save(studio.draw(*this));
    save_turntable(studio, *this, turn, std::get<Textured>(objects[middle].paint).mapping.rotation);
  }

  /// The color seen along a ray.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    return color_along(objects, ray, stage.sky, [&](const Object& object, const Hit<Real>& hit) {
      const Illumination<Real> lamp = illumination(stage.light, phong.casters(objects), hit);
      const Color<Real> color = object.paint(hit);
      const Real matt = lambert(object.finish.matt, lamp);
      const Real gloss = phong.highlight(object.finish, lamp, hit.normal, -ray.direction);
      if (!phong.blends || &object != &objects[middle]) return color * matt + gray(gloss);
      return mix(gray(clamp(matt + gloss, Real(0), Real(1))), color, Real(phong.blend));
    });
  }
};

}  // namespace texmap::chapter_06
