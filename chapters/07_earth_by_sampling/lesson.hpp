// The lesson of this chapter; `idea` says what it adds to the chapter before.
#pragma once
#include <optional>
#include <vector>

#include "budget_options.hpp"
#include "camera.hpp"
#include "gather.hpp"
#include "lens_options.hpp"
#include "painted.hpp"
#include "path.hpp"
#include "sampling_options.hpp"
#include "scene.hpp"
#include "studio.hpp"
#include "texture_file.hpp"

namespace texmap::chapter_07 {

using Textured = Mapped<BudgetMapping, BudgetTexture>;
using Object = Painted<Textured>;
template <class Real>
using Scene = SceneIn<Real, Textured>;

struct Lesson {
  static constexpr const char* idea = "many samples a pixel, and light that comes from everywhere";

  struct {
    GradientSky sky{.below = {0.7, 0.8, 1.0}, .above = {0.7, 0.8, 1.0}};
    Camera camera{.eye = {0, 0, 12}, .target = {0, 0, 0}, .fov_y_degrees = 20};
  } stage;
  std::vector<Object> objects = {{{{0.0, 0.0, 0.0}, 2.0}, {}}};
  TextureFile texture{"earth.png"};
  SamplingOptions sampling;
  LensOptions lens;
  BudgetOptions budget;
  Gathering gathering;

  void options(CommandLine& line) {
    texture.declare(line);
    sampling.declare(line);
    lens.declare(line);
    budget.declare(line);
  }
  void prepare(Studio& studio) {
    studio.prefer_size(400, 225);
    studio.prefer_samples(100);
    objects[0].paint = budget.settle(studio, {.image = texture.load(), .light = sampling.decoding});
    sampling.srgb_terms = budget.srgb_terms;
    if (lens.gradient) stage.sky = {.below = {1, 1, 1}, .above = {0.5, 0.7, 1}};
  }
  void show(Studio& studio) { studio.save(sampling.gather(studio, *this)); }

  /// Where the globe may be seen, and what light comes from beside it.
  [[nodiscard]] std::optional<Foresight> foresight(const View& view) const {
    if (lens.blurs() || objects.size() != 1) return {};
    return Foresight{screen_bounds(view, objects[0].sphere),
                     stage.sky.is_constant() ? std::optional(stage.sky.below) : std::nullopt, budget.smoothing};
  }
  /// What all samples have in common.
  template <class Real>
  [[nodiscard]] auto ready(const View& view) const {
    return ready_scene<Real>(view, objects, stage.sky);
  }

  /// The light of one sample of a pixel.
  template <class Real, class Numbers>
  [[nodiscard]] Color<Real> operator()(const Scene<Real>& scene, const Real& column, const Real& row, Numbers& numbers) const {
    const Ray<Real> ray = lens.ray(scene.view, column, row, numbers);
    const auto albedo = [](const auto& object, const Hit<Real>& hit) { return object.paint(hit); };
    return light_along(scene.objects, ray, scene.sky, albedo, sampling.bounces, numbers);
  }
};

}  // namespace texmap::chapter_07
