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

/// Time of a sample by `mis` / by `cosine`: medians of 41 alternating pairs, chapter 12 in packs of
/// double on one thread: 1.4 under a gradient, 1.6 under the sun. (A constant sky has no choice.)
inline constexpr double cost_of_mis = 1.5;

/// The way with the smaller error in equal time: noise^2 times cost. A constant sky needs no more
/// than the cosine. The chapter's skies ask for the same way if `cost` is 100 times too large or
/// too small.
///
/// @param cost  of `mis`, in units of the cosine's
[[nodiscard]] SkyLighting best_lighting(const SkyNoise& noise, double cost = cost_of_mis);

}  // namespace texmap
