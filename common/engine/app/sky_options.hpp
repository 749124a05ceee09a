// The options of a sky that is a picture.
#pragma once
#include <optional>
#include <string>

#include "scene/camera.hpp"
#include "scene/sky_path.hpp"
#include "texture/sky_light.hpp"

namespace texmap {

class CommandLine;
class Session;

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
  TexelFilter filter = TexelFilter::bilinear;
  std::optional<SkyLighting> chosen;  ///< by the user; else the program chooses
  MatteLight matte;                   ///< what is drawn, once the sky is loaded

  void declare(CommandLine& line);
  /// The sky as a light; chooses `matte.way` unless the user did, and says so.
  /// Errors: FileError with the file and where it was looked for.
  [[nodiscard]] SkyLight load(const Session& session);
};

}  // namespace texmap
