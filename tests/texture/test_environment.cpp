// Tests of common/texture/environment.hpp: what a ray sees of a sky that is a picture.
#include "texture/environment.hpp"

#include <doctest.h>

#include <cmath>

#include "support/made_pictures.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::test {
namespace {

/// The direction of a place on the map, in texels from its upper left corner.
Vec3d toward(const LightImage& map, double column, double row) {
  return direction_rtiow(Uv<double>{column / map.width, 1 - row / map.height});
}

double apart(const Color<double>& a, const Color<double>& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

}  // namespace

TEST_CASE("at the centers of texels a sky has their light, between them a mix of four") {
  const LightImage map = light_noise(16, 8);
  const Environment sky(map), nearest(map, TexelFilter::nearest);
  for (double row = 0.5; row <= 7.5; row += 0.25) {
    for (double column = 0.5; column <= 15.5; column += 0.25) {
      Color<double> sum{};
      for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x) {
          const double weight = std::max(0.0, 1 - std::abs(column - x - 0.5)) *
                                std::max(0.0, 1 - std::abs(row - y - 0.5));
          sum = sum + number_cast<double>(map.at(x, y)) * weight;
        }
      }
      const Ray<double> ray{{}, toward(map, column, row)};
      CHECK(apart(sky(ray), sum) < 1e-10);
      const bool at_center = std::fmod(column, 1) == 0.5 && std::fmod(row, 1) == 0.5;
      if (at_center) CHECK(apart(nearest(ray), sum) < 1e-10);
    }
  }
}

TEST_CASE("a bilinear sky has no seam, and goes on over the poles") {
  const Environment sky(light_noise(16, 8));
  const auto light = [&](const Vec3d& d) { return sky(Ray<double>{{}, d}); };
  for (double row = 0.1; row < 8; row += 0.37) {
    const double seam =
        apart(light(toward(sky.map(), 1e-9, row)), light(toward(sky.map(), 16 - 1e-9, row)));
    CHECK(seam < 1e-5);
  }
  // On both sides of a pole, 1e-9 texels away, the light is the same; across from it, another.
  for (const double row : {1e-9, 8 - 1e-9}) {
    for (double column = 0.3; column < 8; column += 1) {
      const double over =
          apart(light(toward(sky.map(), column, row)), light(toward(sky.map(), column + 8, row)));
      CHECK(over < 1e-5);
    }
  }
  // At a pole half of each side is seen.
  const auto top = [&](int column) { return static_cast<double>(sky.map().at(column, 0).r); };
  const double both = (top(3) + top(4) + top(11) + top(12)) / 4;
  CHECK(light(toward(sky.map(), 4, 1e-9)).r == doctest::Approx(both).epsilon(1e-6));
}

TEST_CASE("a turned sky is the sky seen in the other direction") {
  const LightImage map = light_noise(16, 8);
  const Environment still(map), turned(map, TexelFilter::bilinear, 37);
  for (double row = 0.2; row < 8; row += 0.7) {
    for (double column = 0.1; column < 16; column += 0.9) {
      const Vec3d d = toward(map, column, row);
      CHECK(apart(turned(Ray<double>{{}, rotation_y(37)(d)}), still(Ray<double>{{}, d})) < 1e-9);
      CHECK(length(turned.to_map(turned.from_map(d)) - d) < 1e-15);
    }
  }
}

TEST_CASE("a sky of equal texels is constant, and one channel off by a rounding is not") {
  LightImage map(4, 2, {0.1F, 0.2F, 0.3F});
  CHECK(Environment(map).is_constant());
  CHECK(Environment(map)(Ray<double>{{}, {0, 0, 0}}).g == static_cast<double>(0.2F));
  map.at(3, 1).b = std::nextafter(0.3F, 1.0F);
  CHECK_FALSE(Environment(map).is_constant());
  CHECK(Environment().is_constant());
  CHECK(Environment()(Ray<double>{{}, {1, 0, 0}}).r == 0);
}

}  // namespace texmap::test
