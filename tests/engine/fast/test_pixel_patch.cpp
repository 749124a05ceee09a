// Patches: what a pixel sees, taken from polynomials, against each line of sight by itself.
#include "engine/fast/pixel_patch.hpp"

#include <doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "engine/fast/pixel_lists.hpp"
#include "engine/fast/prepared_scene.hpp"
#include "support/dice.hpp"
#include "texture/mapped.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

/// The texture's color is the place itself.
struct PlaceTexture {
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    return {uv.u, uv.v, Real(0)};
  }
};
using Paint = Mapped<RtiowMapping, PlaceTexture>;

/// Places in a pixel, along either side.
constexpr std::array in_pixel{-0.5, -0.375, -0.25, -0.125, 0.0, 0.125, 0.25, 0.375, 0.5};

const GradientSky fading{.below = {1, 1, 1}, .above = {0.5, 0.7, 1}};

/// A sphere and a pixel that sees it, from middle to limb, from equator to poles, near and far,
/// small and large, in any corner of a view.
struct Sight {
  Sphere<> sphere;
  View<> view;
  double column, row;
};
Sight any_sight(Dice& dice) {
  const auto power = [&](double low, double high) { return std::abs(dice.any_size(low, high)); };
  Point normal = dice.direction<double>();
  if (dice.once_in(2)) {  // close to a pole
    const double axis = power(-2.5, 0);
    const double angle = 2 * std::numbers::pi * dice.between(0, 1);
    normal = {axis * std::cos(angle), dice.sign() * std::sqrt(1 - axis * axis),
              axis * std::sin(angle)};
  }
  const double cosine = power(-1.5, 0);
  const Point across = number_cast<double>(dice.across(number_cast<long double>(normal)));
  const Point line = normal * -cosine + across * std::sqrt(1 - cosine * cosine);
  const Sphere<> sphere{dice.direction<double>() * power(-1, 2), power(-2, 2)};
  const double distance = power(-2, 3) * sphere.radius;
  const Point eye = sphere.center + normal * sphere.radius - line * distance;
  const double axis = std::hypot(normal.x, normal.z);
  // As much of a pixel as bends it by a part of what can be told.
  const double half = power(-2, -1) * std::min(cosine * cosine, axis * cosine) * sphere.radius;
  const double pixel = std::min(2 * half / (distance + cosine * sphere.radius), 0.2);
  const Camera camera{.eye = eye,
                      .target = eye + line + dice.direction<double>() * dice.between(0, 0.7),
                      .fov_y_degrees = 2 * std::atan(pixel / 2) * 180 / std::numbers::pi};
  const View<> view = view_of(camera, 1, 1);
  const Point seen = line * (1 / dot(line, view.forward));
  return {sphere, view, dot(seen, view.right) / pixel + view.center_column,
          view.center_row - dot(seen, view.up) / pixel};
}

double around(double difference) { return std::abs(difference - std::round(difference)); }

double farthest(const Point& a, const Point& b) { return largest(a - b); }

}  // namespace

TEST_CASE("errors at the nine places of a polynomial grow as stated") {
  // The worst errors are 1 with the signs that all help one corner.
  const auto signs = [](double x, double y) {
    return (x == 0 ? -1.0 : 1.0) * (y == 0 ? -1.0 : 1.0);
  };
  const auto same = [](double value) { return value; };
  const double grown = Biquadratic<double>(at_nine_places<double>(signs), same)(0.5, 0.5);
  CHECK(grown <= Biquadratic<double>::worst_growth);
  CHECK(grown > 0.99 * Biquadratic<double>::worst_growth);
}

TEST_CASE(
    "a patch is off by no more than its curvature_error and its normal_error say, and not by much "
    "less") {
  Dice dice(7);
  double u_off = 0, v_off = 0, direction_off = 0;
  int patches = 0;
  for (int i = 0; i < 100000; ++i) {
    const Sight sight = any_sight(dice);
    const PreparedSphere<double> sphere = prepare<double>(sight.sphere);
    const PixelProbe<double> look = probe_pixel(sight.view, sphere, sight.column, sight.row);
    REQUIRE_FALSE(look.misses);
    if (!(look.curvature_error < infinity<double>()) || look.curvature_error < 1e-9) continue;
    ++patches;
    const Paint paint{};
    const PixelPatch<double, Paint> patch(sight.view, sphere, paint, fading, sight.column,
                                          sight.row);
    for (const double x : in_pixel) {
      for (const double y : in_pixel) {
        const Ray<double> ray{sight.view.eye,
                              direction_through(sight.view, sight.column + x, sight.row + y)};
        const double distance = distance_to(sphere, ray);
        REQUIRE(distance < infinity<double>());
        const Vec3<double> normal = normal_at(sphere, ray, distance);
        const Uv<double> uv = uv_rtiow(normal);
        const Rgb place = patch.albedo(x, y);
        const Vec3<double> upward{patch.normal[0](x, y), patch.normal[1](x, y),
                                  patch.normal[2](x, y)};
        REQUIRE((place.r >= 0 && place.r <= 1));  // on either side of the seam
        u_off = std::max(u_off, around(place.r - uv.u) / look.curvature_error);
        v_off = std::max(v_off, std::abs(place.g - uv.v) / look.curvature_error);
        // Frames make half a turn where z changes sign; elsewhere directions are off like normals.
        if (std::abs(normal.z) < 0.02) continue;
        const Point2<double> sample{dice.between(0, 1), dice.between(0, 1)};
        direction_off = std::max(direction_off, farthest(cosine_direction(upward, sample),
                                                         cosine_direction(normal, sample)) /
                                                    look.normal_error);
      }
    }
  }
  MESSAGE("of ", patches, " patches, per curvature_error u ", u_off, ", v ", v_off,
          "; per normal_error direction ", direction_off);
  CHECK(patches > 20000);
  const auto holds = [](double worst, double stated) {
    CHECK(worst <= stated);
    CHECK(worst > 0.8 * stated);
  };
  holds(u_off, Smoothing::turns_per_curvature_error);
  holds(v_off, Smoothing::half_turns_per_curvature_error);
  holds(direction_off, Smoothing::direction_per_normal_error);
}

TEST_CASE(
    "no ray through a pixel that is told to miss meets the sphere, wherever camera and sphere "
    "are") {
  Dice dice;
  int misses = 0, met = 0;
  for (int i = 0; i < 2000; ++i) {
    // Most often in front of the camera, else anywhere near or around the eye.
    const Point eye = dice.direction<double>() * dice.between(0, 5);
    const Point forward = dice.direction<double>();
    const double away = dice.between(2, 20);
    Sphere<> shape{eye + (forward + dice.direction<double>() * dice.between(0, 0.6)) * away,
                   dice.between(0.05, 0.6) * away};
    if (dice.once_in(4))
      shape = {eye + dice.direction<double>() * dice.between(0, 3), dice.between(0.5, 2)};
    const View<> view = view_of(
        {.eye = eye, .target = eye + forward, .fov_y_degrees = dice.between(20, 90)}, 40, 30);
    const PreparedSphere<double> sphere = prepare<double>(shape);
    for (int k = 0; k < 100; ++k) {
      const double column = dice.below(40), row = dice.below(30);
      const bool told = probe_pixel(view, sphere, column, row).misses;
      const Ray<double> ray =
          ray_through(view, column + dice.between(-0.5, 0.5), row + dice.between(-0.5, 0.5));
      const bool seen = distance_to(sphere, ray) < infinity<double>();
      REQUIRE_FALSE((told && seen));
      misses += told ? 1 : 0;
      met += seen ? 1 : 0;
    }
  }
  CHECK(misses > 50000);
  CHECK(met > 20000);
}

TEST_CASE("the sky's patch is as high as the line of sight, within what it states") {
  Dice dice(3);
  double off = 0;
  for (int i = 0; i < 20000; ++i) {
    Sight sight = any_sight(dice);
    sight.view.pixel = std::abs(dice.any_size(-4, -1));
    const double column = dice.between(-2, 2) / sight.view.pixel;
    const double row = dice.between(-2, 2) / sight.view.pixel;
    const SkyPatch<double> patch(sight.view, fading, column, row);
    for (const double x : {-0.5, 0.0, 0.5}) {
      for (const double y : {-0.5, 0.0, 0.5}) {
        const double height = ray_through(sight.view, column + x, row + y).direction.y;
        off = std::max(off, std::abs(patch.height(x, y) - height) / square(sight.view.pixel / 2));
      }
    }
  }
  MESSAGE("sky's height ", off);
  CHECK(off <= SkyPatch<double>::worst_height);
  CHECK(off > 0.8 * SkyPatch<double>::worst_height);
}
