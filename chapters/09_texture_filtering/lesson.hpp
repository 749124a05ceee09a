// The lesson of this chapter; `idea` says what it adds to the chapter before.
#pragma once
#include <vector>

#include "engine/app/filter_options.hpp"
#include "engine/app/lesson.hpp"
#include "engine/app/texture_file.hpp"
#include "scene/floor.hpp"
#include "scene/paint.hpp"
#include "scene/stage.hpp"
#include "sheet.hpp"
#include "texture/encoded.hpp"
#include "texture/filters.hpp"
#include "texture/floor_mapping.hpp"
#include "texture/mapped.hpp"
#include "texture/rotated.hpp"

namespace texmap::chapter_09 {

using Textured = Mapped<Rotated<RtiowMapping>, FilteredTexture>;
using Ground = Mapped<Rotated<FloorMapping>, FilteredTexture>;
using Object = Painted<Textured>;
enum ObjectIndex { near, far };  // in the order of `objects`

struct Lesson : LessonHooks {
  static constexpr About about{
      .idea = "a pixel shows the mean of all the texels that it covers",
      .size = {1200, 648},
      .size_note = "800x600 with --filter or --budget",
  };

  Stage stage{.camera = {.eye = {0, 1, 0}, .target = {0, 0.62, -2}, .fov_y_degrees = 50}};
  Floor floor{.height = 0};
  Ground ground{.mapping = {rotation_y(23), {.size = 8}}, .texture = {}};
  std::vector<Object> objects = {
      Object{.shape = {.center = {-1.3, 1.0, -4.0}, .radius = 0.4}, .paint = {}},
      Object{.shape = {.center = {6.0, 2.4, -24.0}, .radius = 0.4}, .paint = {}},
  };
  TextureFile texture{"earth.png"};
  FilterOptions filtering;

  void options(CommandLine& line) override { offer(line, texture, filtering); }
  void prepare(Session&) override {
    ground.texture = filtering.load_floor();
    const FilteredTexture globe = filtering.load_globe(texture);
    for (Object& object : objects) object.paint = Textured{{rotation_y(60), {}}, globe};
  }
  void show(Session& session) override { show_filters(*this, session); }

  /// Lets all textures be read by a filter.
  void use(Filter filter, int taps) {
    filtering.apply(filter, taps, ground.texture);
    for (Object& object : objects) filtering.apply(filter, taps, object.paint.texture);
  }

  /// True if rays bring their derivatives by the pixel's column and row.
  bool needs_footprints() const { return filtering.needs_footprints(); }

  /// The light that one ray sees: the globes', behind them the floor's, behind it the sky's.
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    const auto behind = [&](const Ray<Real>& to_floor) {
      const Real distance = distance_to(floor, to_floor);
      const Mask<Real> met = distance < infinity<Real>();
      const Vec3<Real> point = point_on(floor, to_floor, select(met, distance, Real(1)));
      return select(met, ground.texture(ground.mapping(point)), stage.sky(to_floor));
    };
    return color_along(objects, ray, behind, [](const Object& object, const Hit<Real>& hit) {
      return object.paint(hit);
    });
  }

  /// The mean light of a pixel as its color; bytes are cut off, so half of one is added.
  template <class Real>
  Color<Real> shown(const Color<Real>& light) const {
    return encoded(light) + gray(Real(0.5 / 255));
  }
};

}  // namespace texmap::chapter_09
