// The options of a sky that is a picture, and which way to gather its light it requires.
#pragma once
#include <optional>
#include <string>

#include "scene/camera.hpp"
#include "scene/sky_path.hpp"
#include "texture/sky_light.hpp"

namespace texmap {

struct Offer;
class Chosen;

/// A stage whose light comes from a picture of the sky alone.
struct SkyStage {
  Camera camera{};
  SkyLight sky{};
};

/// The user's choices of a sky and of how its light is gathered.
struct SkyOptions {
  std::string name = "sky.hdr";  ///< a path, or a file in assets/
  double exposure = 0;           ///< stops: the light times 2^exposure
  double degrees = 0;            ///< turn of the sky about +y
  bool mirrored = false;         ///< the file's left and right exchanged
  TexelFilter filter = TexelFilter::bilinear;
  std::optional<SkyLighting> chosen;  ///< by the user; else the program chooses
  MatteLight matte;                   ///< what is drawn, once the sky is loaded

  void declare(Offer& offer);
  /// The sky as a light; chooses `matte.way` unless the user did, and says so.
  /// Errors: FileError with the file and where it was looked for.
  [[nodiscard]] SkyLight load(const Chosen& user);
};

/// How far the light of one sample is off, root mean square, relative to the light: over matte
/// surfaces that face the six axes without shadows.
struct SkyNoise {
  double cosine = 0, mis = 0;
};

/// The noise of both ways, summed over the picture's texels; no random number is drawn.
[[nodiscard]] SkyNoise noise_of(const SkyLight& sky);

/// Time of a sample by `mis` / by `cosine`: the median of 5 alternating pairs, chapter 12 in packs
/// of double on one thread, from 2.5 to 3.2. (A constant sky has no choice.)
inline constexpr double cost_of_mis = 2.8;

/// The way with the smaller error in equal time: noise^2 times cost. A constant sky needs no more
/// than the cosine. The chapter's skies ask for the same way if `cost` is 10 times too large or
/// too small.
///
/// @param cost  of `mis`, in units of the cosine's
[[nodiscard]] SkyLighting best_lighting(const SkyNoise& noise, double cost = cost_of_mis);

}  // namespace texmap
