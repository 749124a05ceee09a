// Patches: what a pixel shows, probed nine times for all of its samples. Without them chapter 07's
// book scene takes 1.1 times as long under levels=1 with 16 samples, 1.5 with 100, 1.7 with 1000;
// under the gradient sky 1.0, 1.25 and 1.3.
#pragma once
#include <utility>

#include "engine/fast/biquadratic.hpp"
#include "engine/fast/prepared_scene.hpp"
#include "sampling/directions.hpp"
#include "scene/sky.hpp"

namespace texmap {

/// A paint that can compute its (u, v) apart from its color.
template <class Paint, class Real>
concept HasMapping = requires(const Paint& paint, const Vec3<Real>& normal) {
  paint.texture(paint.mapping(normal));
};

/// What a pixel shows of a lone textured sphere: (u, v) and normal as polynomials of the place in
/// the pixel, so a sample asks neither the sphere nor the mapping.
/// Source: Igehy, "Tracing Ray Differentials" (1999), with interpolation instead of derivatives.
template <class Real, HasMapping<Real> Paint>
struct PixelPatch {
  const Paint& paint;
  const GradientSky& sky;
  Biquadratic<Real> u, v;
  std::array<Linear<Real>, 3> normal;  ///< its x, y and z; only for a sky that changes

  /// Domain: pixels with finite errors in probe_pixel.
  /// Bound: that of Smoothing, and the errors of the nine probes times Biquadratic::worst_growth.
  PixelPatch(const View<Real>& view, const PreparedSphere<Real>& sphere,
             const Paint& paint_of_sphere, const GradientSky& sky_beyond, const Real& column,
             const Real& row)
      : paint(paint_of_sphere), sky(sky_beyond) {
    const auto nine = at_nine_places<Real>([&](const Real& x, const Real& y) {
      const Ray<Real> ray{view.eye, direction_through(view, column + x, row + y)};
      const Vec3<Real> at = normal_at(sphere, ray, distance_to(sphere, ray));
      return std::pair(paint.mapping(at), at);
    });
    // Beyond the seam u continues below 0 or above 1.
    const Real middle = nine[1][1].first.u;
    u = Biquadratic<Real>(nine, [&middle](const auto& look) {
      const Real turns = select(look.first.u - middle > Real(0.5), Real(1), Real(0));
      return look.first.u - select(look.first.u - middle < Real(-0.5), Real(-1), turns);
    });
    v = Biquadratic<Real>(nine, [](const auto& look) { return look.first.v; });
    if (sky.is_constant()) return;
    const auto coordinate = [&](auto axis) {
      return Biquadratic<Real>(nine, [axis](const auto& look) { return look.second.*axis; })
          .linear();
    };
    normal = {coordinate(&Vec3<Real>::x), coordinate(&Vec3<Real>::y), coordinate(&Vec3<Real>::z)};
  }

  /// The texture's color at a place in the pixel, x and y in [-1/2, 1/2].
  [[nodiscard]] Color<Real> albedo(const Real& x, const Real& y) const {
    auto uv = decltype(paint.mapping(Vec3<Real>{})){u(x, y), v(x, y)};
    uv.u = uv.u - floor(uv.u);
    return paint.texture(uv);
  }

  /// The light of one sample: light_past_one with the same random numbers.
  template <class Random>
  [[nodiscard]] Color<Real> operator()(Random& random) const {
    const Point2<Real>& in_pixel = random.next_2d();
    const Real x = in_pixel.u - Real(0.5);
    const Real y = in_pixel.v - Real(0.5);
    if (sky.is_constant()) return albedo(x, y) * number_cast<Real>(sky.below);
    const Vec3<Real> upward{normal[0](x, y), normal[1](x, y), normal[2](x, y)};
    return albedo(x, y) * sky(Ray<Real>{{}, cosine_direction(upward, random.next_2d())});
  }
};

/// What a pixel shows of the sky: the height of the ray as a polynomial of degree 1.
template <class Real>
struct SkyPatch {
  const GradientSky& sky;
  Linear<Real> height;

  /// Bound: worst_height times the square of half of a pixel's width at distance 1.
  SkyPatch(const View<Real>& view, const GradientSky& seen, const Real& column, const Real& row)
      : sky(seen) {
    const auto nine = at_nine_places<Real>([&](const Real& x, const Real& y) {
      return ray_through(view, column + x, row + y).direction.y;
    });
    height = Biquadratic<Real>(nine, [](const Real& y) { return y; }).linear();
  }
  static constexpr double worst_height = 0.55;

  /// The light of one sample.
  template <class Random>
  [[nodiscard]] Color<Real> operator()(Random& random) const {
    const Point2<Real>& in_pixel = random.next_2d();
    return sky(
        Ray<Real>{{}, {Real(0), height(in_pixel.u - Real(0.5), in_pixel.v - Real(0.5)), Real(0)}});
  }
};

}  // namespace texmap
