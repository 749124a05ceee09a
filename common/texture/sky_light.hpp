// A sky prepared as a light: its picture, its sampler and its nine numbers.
#pragma once
#include <utility>

#include "texture/environment.hpp"
#include "texture/sky_moments.hpp"
#include "texture/sky_sampler.hpp"

namespace texmap {

/// A sky that light_under_sky can ask for directions and for its light as a whole.
struct SkyLight {
  Environment picture;
  SkySampler sampler;
  SkyMoments moments;

  SkyLight() = default;
  explicit SkyLight(Environment sky)
      : picture(std::move(sky)), sampler(picture), moments(picture) {}

  [[nodiscard]] bool is_constant() const { return picture.is_constant(); }
  /// The light along a ray; as Environment's.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    return picture(ray);
  }
  /// A direction drawn in proportion to the sky's light, and the density of any direction.
  template <class Real>
  [[nodiscard]] Vec3<Real> direction(const Point2<Real>& texel, const Point2<Real>& within) const {
    return sampler.direction(picture, texel, within);
  }
  template <class Real>
  [[nodiscard]] Real density(const Vec3<Real>& direction) const {
    return sampler.density(picture, direction);
  }
  /// The light that a white matte surface with this normal sends out, by nine numbers.
  template <class Real>
  [[nodiscard]] Color<Real> reflected(const Vec3<Real>& normal) const {
    return moments.reflected(picture.to_map(normal));
  }
};

}  // namespace texmap
