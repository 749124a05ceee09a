// Which way to gather a sky's light its picture requires.
#pragma once
#include <array>

#include "scene/sky_path.hpp"
#include "texture/sky_light.hpp"

namespace texmap {

/// How far one direction's light is off, root mean square, relative to the light: over matte
/// surfaces that face the six axes without shadows.
struct SkyNoise {
  double uniform = 0, cosine = 0, importance = 0, mis = 0;
};

/// The noise of each way, summed over the picture's texels; no random number is drawn.
[[nodiscard]] SkyNoise noise_of(const SkyLight& sky);

/// How long a direction takes, drawn by `way` and followed, in units of SkyLighting::cosine.
[[nodiscard]] double cost_of(SkyLighting way);

/// The way with the smallest error in equal time: noise^2 times cost. A constant sky needs no more
/// than the cosine.
[[nodiscard]] SkyLighting best_lighting(const SkyNoise& noise);

}  // namespace texmap
