// The lesson of this chapter; `idea` says what it adds to the chapter before.
#pragma once
#include <vector>

#include "engine/draw/lesson.hpp"
#include "engine/run/sampling_options.hpp"
#include "engine/run/sky_options.hpp"
#include "scene/paint.hpp"
#include "scene/sky_path.hpp"
#include "scene/stage.hpp"
#include "texture/sky_light.hpp"

namespace texmap::chapter_12 {

using Object = Painted<Coat>;
enum ObjectIndex { matte, mirroring, small, ground };  // in the order of `objects`

struct Lesson : PathLesson {
  static constexpr About about{
      .idea = "a picture as the sky: seen, mirrored, and as the light of matte surfaces",
      .size = {800, 450},
  };

  SkyStage stage{.camera = {.eye = {0, 1.2, 9}, .target = {0, 0.35, 0}, .fov_y_degrees = 32}};
  std::vector<Object> objects = {
      Object{.shape = {.center = {-1.5, 0.0, 0.0}, .radius = 1.0}, .paint = {.color = white}},
      Object{.shape = {.center = {1.0, 0.0, -0.5}, .radius = 1.0},
             .paint = {.color = white, .mirrors = true}},
      Object{.shape = {.center = {0.1, -0.6, 1.4}, .radius = 0.4}, .paint = {.color = red}},
      Object{.shape = {.center = {0, -1001, 0}, .radius = 1000}, .paint = {{0.5, 0.48, 0.42}}},
  };
  SkyOptions sky;

  Lesson() { sampling = {.sampler = SamplerKind::multi_jitter, .samples = 32}; }
  Groups options() override { return {sky, sampling}; }
  void build(Chosen& chosen) override { stage.sky = sky.load(chosen); }

  /// The color that one ray sees.
  template <class Real>
  Color<Real> operator()(const auto& scene, const PixelPlace<Real>& at, auto& random) const {
    const Ray<Real> ray = sampling.lens.ray(scene.view, at, random);
    return light_under_sky(scene.objects, ray, scene.sky, sky.matte, sampling.bounces, random);
  }
};

}  // namespace texmap::chapter_12
