// The stage of a scene: everything but the objects.
#pragma once
#include "camera.hpp"
#include "light.hpp"
#include "sky.hpp"

namespace texmap {

/// A lamp, a sky and a camera. The values are seed 0's scene in a right-handed world, on which chapters 01 to 06 play.
struct Stage {
  PointLight light{.position = {5, 5, 5}};
  GradientSky sky{.below = {1, 1, 1}, .above = {0.5, 0.7, 1}};
  Camera camera{.eye = {0, 2, 8}, .target = {0, 0, 0}, .fov_y_degrees = 60};
};

}  // namespace texmap
