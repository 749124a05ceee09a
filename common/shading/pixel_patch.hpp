// What a pixel sees, looked at nine times for all of its samples.
#pragma once
#include <utility>

#include "biquadratic.hpp"
#include "camera.hpp"
#include "color.hpp"
#include "directions.hpp"
#include "sky.hpp"
#include "sphere.hpp"

namespace texmap {

/// A paint in two parts, whose (u, v) can be had apart from its color.
template <class Paint, class Real>
concept HasMapping = requires(const Paint& paint, const Vec3<Real>& normal) {
  paint.texture(paint.mapping(normal));
};

/// What a pixel sees of a lone textured sphere: (u, v) and normal as polynomials of the place in the pixel. A path that begins
/// there asks neither the sphere nor the mapping.
///
/// Source: carrying on from one ray to its neighbours by derivatives is Igehy's, "Tracing Ray Differentials" (1999); here they
/// come from interpolation, for places up to the second degree.
template <class Real, HasMapping<Real> Paint>
struct PixelPatch {
  const Paint& paint;
  const GradientSkyIn<Real>& sky;
  Biquadratic<Real> u, v;
  std::array<Linear<Real>, 3> normal;  ///< x, y and z of it, for a sky that changes

  /// @param column, row  of the pixel
  /// Domain: pixels whose bend and tilt, as look_through gives them, are finite. Bound: as Smoothing has it, besides the errors
  /// of the nine looks, which grow by at most Biquadratic::worst_growth.
  PixelPatch(const ViewIn<Real>& view, const SphereIn<Real>& sphere, const Paint& paint_of_sphere,
             const GradientSkyIn<Real>& sky_beyond, const Real& column, const Real& row)
      : paint(paint_of_sphere), sky(sky_beyond) {
    const auto nine = at_nine_places<Real>([&](const Real& x, const Real& y) {
      const Ray<Real> ray{view.eye, direction_through(view, column + x, row + y)};
      const Vec3<Real> at = normal_at(sphere, ray, distance_to(sphere, ray));
      return std::pair(paint.mapping(at), at);
    });
    // Across the seam of u the polynomial goes on beyond 0 or 1.
    const Real middle = nine[1][1].first.u;
    u = Biquadratic<Real>(nine, [&middle](const auto& look) {
      const Real turns = select(look.first.u - middle > Real(0.5), Real(1), Real(0));
      return look.first.u - select(look.first.u - middle < Real(-0.5), Real(-1), turns);
    });
    v = Biquadratic<Real>(nine, [](const auto& look) { return look.first.v; });
    if (sky.is_constant()) return;
    const auto coordinate = [&](auto axis) {
      return Biquadratic<Real>(nine, [axis](const auto& look) { return look.second.*axis; }).linear();
    };
    normal = {coordinate(&Vec3<Real>::x), coordinate(&Vec3<Real>::y), coordinate(&Vec3<Real>::z)};
  }

  /// The texture's color at a place in the pixel, each coordinate in [-1/2, 1/2].
  [[nodiscard]] Color<Real> albedo(const Real& x, const Real& y) const {
    auto uv = decltype(paint.mapping(Vec3<Real>{})){u(x, y), v(x, y)};
    uv.u = uv.u - floor(uv.u);
    return paint.texture(uv);
  }

  /// The light of one sample, as light_past_one has it from the same numbers.
  template <class Numbers>
  [[nodiscard]] Color<Real> operator()(Numbers& numbers) const {
    const Sample2<Real>& in_pixel = numbers.pair();
    const Real x = in_pixel.u - Real(0.5);
    const Real y = in_pixel.v - Real(0.5);
    if (sky.is_constant()) return albedo(x, y) * sky.below;
    const Vec3<Real> upward{normal[0](x, y), normal[1](x, y), normal[2](x, y)};
    return albedo(x, y) * sky(Ray<Real>{{}, cosine_direction(upward, numbers.pair())});
  }
};

/// What a pixel sees of the sky: the height of the line of sight as a polynomial of the first degree.
template <class Real>
struct SkyPatch {
  const GradientSkyIn<Real>& sky;
  Linear<Real> height;

  /// Bound: the height is off by at most worst_height times the square of half of a pixel's width at distance 1; held in
  /// tests/shading/test_pixel_patch.cpp.
  SkyPatch(const ViewIn<Real>& view, const GradientSkyIn<Real>& seen, const Real& column, const Real& row) : sky(seen) {
    const auto nine =
        at_nine_places<Real>([&](const Real& x, const Real& y) { return ray_through(view, column + x, row + y).direction.y; });
    height = Biquadratic<Real>(nine, [](const Real& y) { return y; }).linear();
  }
  static constexpr double worst_height = 0.55;

  /// The light of one sample.
  template <class Numbers>
  [[nodiscard]] Color<Real> operator()(Numbers& numbers) const {
    const Sample2<Real>& in_pixel = numbers.pair();
    return sky(Ray<Real>{{}, {Real(0), height(in_pixel.u - Real(0.5), in_pixel.v - Real(0.5)), Real(0)}});
  }
};

}  // namespace texmap
