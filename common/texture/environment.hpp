// A picture of everything around: the sky of a scene.
#pragma once
#include <algorithm>
#include <array>
#include <utility>

#include "math/rotation.hpp"
#include "number/table.hpp"
#include "scene/ray.hpp"
#include "texture/bilinear_mix.hpp"
#include "texture/light_image.hpp"
#include "texture/texel.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// How a color is found between the centers of texels.
enum class TexelFilter {
  nearest,   ///< the texel that holds the place
  bilinear,  ///< mixed from the four nearest, over the poles too
};

/// `bilinear_mix` on an equirectangular map, which goes on over its poles at the other side.
///
/// @param texel_at  called with a column, and a row counted from v = 0, both in the map
/// @param uv        u and v from 0 to 1
/// @param width     even
template <class Real, class TexelAt>
[[nodiscard]] auto mixed_on_sphere(const TexelAt& texel_at, const Uv<Real>& uv, int width,
                                   int height) {
  const auto inside = [&](const Real& column, const Real& row) {
    const Real inside_row = clamp(row, Real(0), Real(height - 1));
    const int half = width / 2;
    const Real turned = column + select(row == inside_row, Real(0), Real(half));
    const Real before = select(turned < Real(width), Real(0), Real(width));
    return texel_at(turned - select(turned < Real(0), Real(-width), before), inside_row);
  };
  return bilinear_mix(inside, uv.u * Real(width) - Real(0.5), uv.v * Real(height) - Real(0.5));
}

/// A sky painted on a sphere without end: a ray's direction alone decides what it sees.
/// The picture is an equirectangular map, placed by uv_rtiow: its middle is at +x, +z to the left.
class Environment {
 public:
  Environment() : Environment(LightImage(1, 1)) {}
  /// @param map      of even width, unless all its texels are equal; not empty
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
    if (constant_) return number_cast<Real>(map_.pixels.front());
    if (filter_ == TexelFilter::nearest) {
      const auto channels = look_up(
          [this](int column, int row) {
            const Color<float>& light = map_.at(column, row);
            return std::array{light.r, light.g, light.b};
          },
          texel_place(uv, map_.width, map_.height, VAxis::up, TexelRounding::floor));
      return {channels[0], channels[1], channels[2]};
    }
    const auto texel_at = [&](const Real& column, const Real& row) {
      return light_at(map_, column, Real(map_.height - 1) - row);
    };
    return mixed_on_sphere(texel_at, uv, map_.width, map_.height);
  }

 private:
  LightImage map_;
  TexelFilter filter_;
  RotationY to_map_;
  bool constant_ = true;
};

}  // namespace texmap
