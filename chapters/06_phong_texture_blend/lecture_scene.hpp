// The lecture's scene (seed 4): a globe over a yellow ground, lit without shadows, on black.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "conventions.hpp"
#include "solid.hpp"
#include "studio.hpp"

namespace texmap::chapter_06 {

/// Puts the lecture's objects, lamp, sky and camera in the place of the stage's.
///
/// The lecture looks from (0, 0, 4) through the points (-2 + i step, 1 - j step, 2) with step = 4 / width: twice as wide as
/// high, from the tangent 1/2 up to the tangent 1/2 down, through the corners of pixels.
template <class Lesson>
void set_lecture_scene(Lesson& lesson, Studio& studio) {
  const Solid white{{1, 1, 1}};
  const Solid yellow{{1, 1, 0}};
  lesson.objects = {
      {{{0, 0, 0}, 1}, white, {.matt = {.ambient = 0.2, .diffuse = 0.5}, .specular = 0.3, .shininess = 500}},
      {{{0, -101, -1}, 100}, yellow, {.matt = {.ambient = 0.2, .diffuse = 0.8}, .specular = 0.3, .shininess = 50}},
  };
  lesson.stage = {
      .light = {.position = {3, 2, 2}},
      .sky = {.below = {0, 0, 0}, .above = {0, 0, 0}},
      .camera =
          {
              .eye = {0, 0, 4},
              .target = {0, 0, 0},
              .fov_y_degrees = 2 * std::atan(0.5) * 180 / std::numbers::pi,
              .anchor = PixelAnchor::corner,
          },
  };
  if (!studio.typed("--convention")) lesson.layout.convention = Convention::lecture;
  if (!studio.typed("--degrees")) lesson.turn.degrees = 0;
  studio.prefer_size(800, std::max(1, (studio.typed("--width") ? studio.width : 800) / 2));
}

}  // namespace texmap::chapter_06
