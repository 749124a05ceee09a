// The scene that the user chose: the stage, or the lecture's globe over a yellow ground.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/run/chosen.hpp"
#include "engine/run/phong_options.hpp"
#include "scene/paint.hpp"
#include "scene/stage.hpp"
#include "texture/conventions.hpp"

namespace texmap::chapter_06 {

/// Puts the lecture's objects, light, sky and camera in the place of the stage's.
///
/// The lecture looks from (0, 0, 4) through (-2 + i step, 1 - j step, 2) with step = 4 / width. The
/// rays go through pixel corners. The picture is twice as wide as high; its upper and lower edges
/// are at the tangents 1/2 and -1/2.
template <class Lesson>
void set_lecture_scene(Lesson& lesson, Chosen& chosen) {
  const Solid paper{{1, 1, 1}};
  const Solid yellow{{1, 1, 0}};
  lesson.objects = {
      {{{0, 0, 0}, 1},
       paper,
       {.lambertian = {.ambient = 0.2, .diffuse = 0.5}, .specular = 0.3, .shininess = 500}},
      {{{0, -101, -1}, 100},
       yellow,
       {.lambertian = {.ambient = 0.2, .diffuse = 0.8}, .specular = 0.3, .shininess = 50}},
  };
  lesson.stage = {
      .light = {.position = {3, 2, 2}},
      .sky = {.below = {0, 0, 0}, .above = {0, 0, 0}},
      .camera =
          {
              .eye = {0, 0, 4},
              .target = {0, 0, 0},
              .fov_y_degrees = 2 * atan2(0.5, 1.0) * 180 / std::numbers::pi,
              .anchor = PixelAnchor::corner,
          },
  };
  if (!chosen.was_given("--convention")) lesson.layout.convention = Convention::lecture;
  if (!chosen.was_given("--degrees")) lesson.turn.degrees = 0;
  chosen.default_size(800,
                      std::max(1, (chosen.was_given("--width") ? chosen.settings.width : 800) / 2));
}

/// The stage, or the lecture's scene if the user asks for it, and the globe's highlight.
template <class Lesson>
void choose_scene(Lesson& lesson, Chosen& chosen) {
  if (lesson.phong.resolve(chosen) == PhongScene::lecture) set_lecture_scene(lesson, chosen);
  lesson.phong.apply_to(lesson.objects.front().material, chosen);
}

}  // namespace texmap::chapter_06
