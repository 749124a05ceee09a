// A picture of everything around: the sky of a scene.
#pragma once
#include <algorithm>
#include <array>
#include <utility>

#include "math/rotation.hpp"
#include "number/table.hpp"
#include "scene/ray.hpp"
#include "texture/light_image.hpp"
#include "texture/texel.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// How a color is found between the centers of texels.
enum class TexelFilter {
  nearest,   ///< the texel that holds the place
  bilinear,  ///< mixed from the four nearest, over the poles too
};

/// A texel of a map: whole numbers, the row counted from v = 0.
template <class Real>
struct TexelOfMap {
  Real column, row;
};

/// The four texels about a place on an equirectangular map, and where it lies between them.
template <class Real>
struct FourTexels {
  std::array<TexelOfMap<Real>, 4> texels;  ///< lower left, lower right, upper left, upper right
  Real across, up;                         ///< 0 to 1, from the left and from the lower ones
};

/// Texels' centers are at (column + 1/2) / width; over the poles the map goes on at the other side.
/// @param uv     u and v from 0 to 1
/// @param width  even
template <class Real>
[[nodiscard]] FourTexels<Real> four_texels(const Uv<Real>& uv, int width, int height) {
  const Real x = uv.u * Real(width) - Real(0.5);
  const Real y = uv.v * Real(height) - Real(0.5);
  const Real left = floor(x);
  const Real low = floor(y);
  const int half = width / 2;
  const auto at = [&](Real column, const Real& row) {
    const Real inside = clamp(row, Real(0), Real(height - 1));
    column = column + select(row == inside, Real(0), Real(half));
    const Real before = select(column < Real(width), Real(0), Real(width));
    return TexelOfMap<Real>{column - select(column < Real(0), Real(-width), before), inside};
  };
  const Real right = left + Real(1);
  const Real high = low + Real(1);
  return {{at(left, low), at(right, low), at(left, high), at(right, high)}, x - left, y - low};
}

/// A sky painted on a sphere without end: a ray's direction alone decides what it sees.
/// The picture is an equirectangular map, placed by uv_rtiow: its middle is at +x, +z to the left.
class Environment {
 public:
  Environment() : Environment(LightImage(1, 1)) {}
  /// @param map      of even width, unless all its texels are equal
  /// @param degrees  turn of the sky about +y, as rotation_y
  explicit Environment(LightImage map, TexelFilter filter = TexelFilter::bilinear,
                       double degrees = 0)
      : map_(std::move(map)), filter_(filter), to_map_(rotation_y(-degrees)) {
    constant_ = std::all_of(map_.pixels.begin(), map_.pixels.end(), [&](const Color<float>& c) {
      const Color<float>& first = map_.pixels.front();
      return c.r == first.r && c.g == first.g && c.b == first.b;
    });
  }

  [[nodiscard]] const LightImage& map() const { return map_; }
  [[nodiscard]] TexelFilter filter() const { return filter_; }
  /// True if all texels are equal: then a ray's direction does not matter.
  [[nodiscard]] bool is_constant() const { return constant_; }

  /// A direction of the world as one of the picture.
  template <class Real>
  [[nodiscard]] Vec3<Real> to_map(const Vec3<Real>& direction) const {
    return to_map_(direction);
  }
  /// A direction of the picture as one of the world.
  template <class Real>
  [[nodiscard]] Vec3<Real> from_map(const Vec3<Real>& direction) const {
    return RotationY{to_map_.cosine, -to_map_.sine}(direction);
  }

  /// The light along a ray with a direction of any length.
  /// Bound: 4 unit roundoffs of the brightest of the four texels for the color, uv_rtiow's place.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    return at(uv_of(ray.direction));
  }

  /// Where a direction of the world, of any length, is on the picture.
  template <class Real>
  [[nodiscard]] Uv<Real> uv_of(const Vec3<Real>& direction) const {
    return uv_rtiow(to_map(direction));
  }

  /// The light at a place on the picture.
  template <class Real>
  [[nodiscard]] Color<Real> at(const Uv<Real>& uv) const {
    if (constant_) {
      const Color<float>& light = map_.pixels.front();
      return {Real(light.r), Real(light.g), Real(light.b)};
    }
    const auto texels = [this](int column, int row) {
      const Color<float>& light = map_.at(column, row);
      return std::array{light.r, light.g, light.b};
    };
    const auto color = [](const std::array<Real, 3>& channels) -> Color<Real> {
      return {channels[0], channels[1], channels[2]};
    };
    if (filter_ == TexelFilter::nearest) {
      return color(look_up(
          texels, texel_place(uv, map_.width, map_.height, VAxis::up, TexelRounding::floor)));
    }
    const FourTexels<Real> four = four_texels(uv, map_.width, map_.height);
    const auto texel = [&](std::size_t i) {
      const TexelOfMap<Real>& one = four.texels[i];
      return color(look_up(texels, one.column, Real(map_.height - 1) - one.row));
    };
    return mix(mix(texel(0), texel(1), four.across), mix(texel(2), texel(3), four.across), four.up);
  }

 private:
  LightImage map_;
  TexelFilter filter_;
  RotationY to_map_;
  bool constant_ = true;
};

}  // namespace texmap
