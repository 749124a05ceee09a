// The heights and the normals that the globe can have.
#pragma once
#include <optional>

#include "engine/run/bump_options.hpp"
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

/// The globe's shading normals: those of heights, or of a normal map if there is one.
struct GlobeBumps : Bumps<Height> {
  std::optional<NormalMap<GlobeMapping, BilinearTexture>> map;

  template <class Real>
  [[nodiscard]] Vec3<Real> operator()(const Hit<Real>& hit, const Real& curvature) const {
    return map ? (*map)(hit, curvature) : Bumps<Height>::operator()(hit, curvature);
  }
  /// The same where a ray met an object.
  template <class Real, class Object>
  [[nodiscard]] Vec3<Real> operator()(const Object& object, const Hit<Real>& hit) const {
    return (*this)(hit, inverse_radius<Real>(object.shape));
  }
};

/// What the user chose: a normal map, or heights with their relief and slopes.
/// Errors: FileError if an image cannot be loaded.
[[nodiscard]] inline GlobeBumps make_bumps(const BumpOptions& options,
                                           const GlobeMapping& mapping) {
  GlobeBumps bumps{{.height = SolidWaves{}}, {}};
  const VAxis v_axis = v_axis_of(mapping.mapping.convention);
  if (!options.normals.empty()) {
    // Green is told relative to the image; the map asks for it relative to v.
    const bool along_v = (options.green == Green::up) == (v_axis == VAxis::up);
    bumps.map = {mapping, options.load_normals(v_axis), along_v ? Green::up : Green::down};
    return bumps;
  }
  if (options.height == HeightKind::uv) bumps.height = Mapped<GlobeMapping, UvWaves>{mapping, {}};
  if (options.height == HeightKind::image) {
    const SharedLight heights = options.load();
    SmoothTexture texture{.image = {}, .v_axis = v_axis};
    if (heights.size() > std::size_t{1} << 22) {
      texture.large = heights;
    } else {  // as floats, which are read faster
      texture.image = image_of(heights.width, heights.height,
                               [&](int column, int row) { return heights.at(column, row); });
    }
    bumps.height = Mapped<GlobeMapping, SmoothTexture>{mapping, texture};
  }
  options.apply_to(bumps);
  return bumps;
}

}  // namespace texmap::chapter_11
