// The lesson of this chapter; `idea` says what it adds to the chapter before.
#pragma once
#include <array>
#include <vector>

#include "checkerboard.hpp"
#include "image_texture.hpp"
#include "mapped.hpp"
#include "painted.hpp"
#include "solid.hpp"
#include "stage.hpp"
#include "studio.hpp"
#include "texture_file.hpp"

namespace texmap::chapter_03 {

using Checkered = Mapped<RtiowMapping, Checkerboard>;
using Textured = Mapped<RtiowMapping, ImageTexture>;
using Paint = AnyOf<Solid, Checkered, Textured>;
using Object = Painted<Paint>;
enum ObjectIndex { middle, left, right, ground };

struct Lesson {
  static constexpr const char* idea = "a picture wrapped round the middle sphere";
  static constexpr std::array changed_objects = {middle};

  Stage stage{.light = {.position = {5, 5, 5}}, .camera = {.eye = {0, 2, 8}, .target = {0, 0, 0}}};
  Matt surface{.ambient = 0.2, .diffuse = 0.8};
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

  void options(CommandLine& line) { texture.declare(line); }
  void prepare(Studio&) { objects[middle].paint = Textured{{}, {texture.load()}}; }

  /// The color seen along a ray.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    return color_along(objects, ray, stage.sky, [&](const Object& object, const Hit<Real>& hit) {
      const Illumination<Real> lamp = illumination(stage.light, objects, hit);
      const Color<Real> color = object.paint(hit);
      return color * lambert(surface, lamp);
    });
  }
};

}  // namespace texmap::chapter_03
