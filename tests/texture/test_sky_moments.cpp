// Tests of common/texture/sky_moments.hpp: a sky as nine numbers.
#include "texture/sky_moments.hpp"

#include <doctest.h>

#include <cmath>

#include "texture/sky_texels.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::test {
namespace {

/// One small texel of light at the top of the sky's right half, and where it is.
struct Lamp {
  LightImage map = LightImage(512, 256);
  Vec3d direction;
  double light = 0;  ///< times its solid angle

  Lamp() {
    map.at(301, 100) = gray(1000.0F);
    direction = direction_rtiow(Uv<double>{301.5 / 512, 1 - 100.5 / 256});
    light = 1000 * SkyBand(100, 512, 256).solid_angle;
  }
};

/// The unit vector at an angle of `cosine` to a lamp.
Vec3d at_cosine(const Vec3d& lamp, double cosine) {
  const Vec3d aside = normalize(cross(lamp, Vec3d{0.3, -0.5, 0.8}));
  return lamp * cosine + aside * std::sqrt(1 - cosine * cosine);
}

}  // namespace

TEST_CASE("a lamp is 17/16 as bright as it is where it is overhead, and 3/32 at the terminator") {
  const Lamp lamp;
  const SkyMoments moments((Environment(lamp.map)));
  const auto over_lambert = [&](double cosine) {
    return moments.reflected(at_cosine(lamp.direction, cosine)).r * std::numbers::pi / lamp.light;
  };
  CHECK(over_lambert(1) == doctest::Approx(17.0 / 16).epsilon(1e-4));
  CHECK(over_lambert(0) == doctest::Approx(3.0 / 32).epsilon(1e-3));
  // Below 0 between the cosines -0.824 and -0.243: there it is 0.
  for (double cosine = -1; cosine < 1; cosine += 0.05) {
    const double closed = 0.25 + cosine / 2 + 5.0 / 32 * (3 * cosine * cosine - 1);
    CHECK(std::abs(over_lambert(cosine) - std::max(closed, 0.0)) < 1e-3);
  }
}

TEST_CASE("a sky of ones gives every normal exactly its own light") {
  const SkyMoments moments(Environment(LightImage(6, 3, gray(1.0F))));
  for (const Vec3d& n : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0.6, 0, 0.8}, Vec3d{0, -0.6, 0.8}})
    CHECK(moments.reflected(n).g == doctest::Approx(1).epsilon(1e-14));
}

}  // namespace texmap::test
