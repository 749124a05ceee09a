// The lesson of this chapter; `idea` says what it adds to the chapter before.
#pragma once
#include <vector>

#include "engine/draw/lesson.hpp"
#include "engine/run/filter_options.hpp"
#include "engine/run/texture_file.hpp"
#include "scene/floor.hpp"
#include "scene/paint.hpp"
#include "scene/stage.hpp"
#include "sheet.hpp"
#include "texture/floor_mapping.hpp"
#include "texture/mapped.hpp"
#include "texture/rotated.hpp"
#include "texture/surface.hpp"

namespace texmap::chapter_09 {

using Textured = Mapped<Rotated<RtiowMapping>, FilteredTexture>;
using Object = Painted<Textured>;

struct Lesson : FilteredLesson {
  static constexpr About about{
      .idea = "a pixel shows the mean of all the texels that it covers",
      .size = {1200, 648},
      .size_note = "800x600 with --filter or --budget",
  };

  Stage stage{.camera = {.eye = {0, 1, 0}, .target = {0, 0.62, -2}, .fov_y_degrees = 50}};
  Floor floor{.height = 0};
  Mapped<Rotated<FloorMapping>, FilteredTexture> ground{{rotation_y(23), {.size = 8}}, {}};
  std::vector<Object> objects = {
      Object{.shape = {.center = {-1.3, 1.0, -4.0}, .radius = 0.4}, .paint = {}},
      Object{.shape = {.center = {6.0, 2.4, -24.0}, .radius = 0.4}, .paint = {}},
  };
  TextureFile texture{"earth.png"};

  Groups options() override { return {texture, filtering}; }
  void build(Chosen& chosen) override {
    ground.texture = filtering.load_floor();
    const Textured globe{{rotation_y(60), {}}, filtering.load_globe(texture)};
    for (Object& object : objects) object.paint = globe;
    choose_scene(*this, chosen);
  }
  Surface<double> first_surface(const Ray<double>& ray) const override {
    const Surface<double> nearest = surface_of(objects, ray);
    if (nearest.object >= 0) return nearest;
    return surface_of(floor, ground.mapping, static_cast<int>(objects.size()), ray);
  }
  void draw_all(Session& session) override { show_filters(*this, session); }

  /// The color that one ray sees.
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    const auto behind = [&](const auto&) { return color_along(floor, ray, stage.sky, ground); };
    return color_along(objects, ray, behind, [](const Object& object, const Hit<Real>& hit) {
      return object.paint(hit);
    });
  }
};

}  // namespace texmap::chapter_09
