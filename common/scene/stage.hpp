// The stage of a scene: light, sky and camera.
#pragma once
#include "scene/camera.hpp"
#include "scene/light.hpp"
#include "scene/sky.hpp"

namespace texmap {

/// The daily exercise's colors.
inline constexpr Rgb white{0.9, 0.9, 0.9};
inline constexpr Rgb blue{0.2, 0.2, 0.8};
inline constexpr Rgb red{1.0, 0.3, 0.3};

/// The daily exercise's light, sky and camera, in a right-handed world.
struct Stage {
  PointLight light{.position = {5, 5, 5}};
  GradientSky sky{.below = {1, 1, 1}, .above = {0.5, 0.7, 1}};
  Camera camera{.eye = {0, 2, 8}, .target = {0, 0, 0}, .fov_y_degrees = 60};
};

}  // namespace texmap
