// The heights that the globe can have.
#pragma once
#include "engine/app/bump_options.hpp"
#include "scene/paint.hpp"
#include "texture/bump.hpp"
#include "texture/conventions.hpp"
#include "texture/mapped.hpp"
#include "texture/rotated.hpp"
#include "texture/smooth_texture.hpp"
#include "texture/waves.hpp"

namespace texmap::chapter_11 {

using GlobeMapping = Rotated<ConventionMapping>;
/// Paints, the red channel of their color being the height.
using Height =
    AnyOf<Mapped<GlobeMapping, SmoothTexture>, Mapped<GlobeMapping, UvWaves>, SolidWaves>;

/// Bumps with the height, the relief and the slopes that the user chose.
/// Errors: FileError if the height image cannot be loaded.
[[nodiscard]] inline Bumps<Height> make_bumps(const BumpOptions& options,
                                              const GlobeMapping& mapping) {
  Bumps<Height> bumps{.height = SolidWaves{}};
  if (options.height == HeightKind::uv) bumps.height = Mapped<GlobeMapping, UvWaves>{mapping, {}};
  if (options.height == HeightKind::image) {
    const VAxis v_axis = v_axis_of(mapping.mapping.convention);
    bumps.height = Mapped<GlobeMapping, SmoothTexture>{mapping, {options.load(), v_axis}};
  }
  options.apply_to(bumps);
  return bumps;
}

}  // namespace texmap::chapter_11
