// A sky prepared as a light: its picture, its sampler and its nine numbers.
#pragma once
#include <utility>

#include "texture/environment.hpp"
#include "texture/sky_moments.hpp"
#include "texture/sky_sampler.hpp"

namespace texmap {

/// Draws by what of a sky is brighter than its mean; by all of it if that is next to nothing. What
/// is not, the direction that the cosine draws finds as well.
/// Source: Karlik et al., "MIS Compensation" (2019).
[[nodiscard]] inline SkySampler sampler_above_mean(const Environment& sky, double total) {
  LightImage rest = sky.map();
  for (Color<float>& texel : rest.pixels) {
    const double above = brightness_of(texel) - total / (4 * pi<double>());
    texel = gray(static_cast<float>(max(above, 0.0)));
  }
  SkySampler sampler(Environment(std::move(rest), sky.filter()));
  return sampler.total() > 0.01 * total ? sampler : SkySampler(sky);
}

/// A sky that light_under_sky can ask for directions and for its light as a whole.
struct SkyLight {
  Environment picture;
  SkySampler sampler;
  SkySampler above_mean;  ///< for `mis`
  SkyMoments moments;

  SkyLight() = default;
  explicit SkyLight(Environment sky)
      : picture(std::move(sky)),
        sampler(picture),
        above_mean(sampler_above_mean(picture, sampler.total())),
        moments(picture) {}

  [[nodiscard]] bool is_constant() const { return picture.is_constant(); }
  /// The light along a ray; as Environment's.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    return picture(ray);
  }
  [[nodiscard]] const SkySampler& sampler_for(bool mis) const { return mis ? above_mean : sampler; }
  /// A direction drawn by the sky's light, and the density of any direction.
  template <class Real>
  [[nodiscard]] SkyDirection<Real> draw(bool mis, const Point2<Real>& sample) const {
    return sampler_for(mis).direction(picture, sample);
  }
  template <class Real>
  [[nodiscard]] Real density(bool mis, const SkyDirection<Real>& drawn) const {
    return sampler_for(mis).density(drawn.direction, drawn.uv);
  }
  /// A direction of unit length with its place on the map.
  template <class Real>
  [[nodiscard]] SkyDirection<Real> toward(const Vec3<Real>& direction) const {
    return {direction, picture.uv_of(direction)};
  }
  /// The light that a white matte surface with this normal sends out, by nine numbers.
  template <class Real>
  [[nodiscard]] Color<Real> reflected(const Vec3<Real>& normal) const {
    return moments.reflected(picture.to_map(normal));
  }
};

}  // namespace texmap
