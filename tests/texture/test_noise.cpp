// Tests of common/texture/noise.hpp and marble.hpp. The error of rounding, tests/extremes searches;
// that packs compute the same, tests/scene/test_lanes.cpp.
#include <doctest.h>

#include "support/dice.hpp"
#include "texture/marble.hpp"
#include "texture/solid_checkerboard.hpp"

namespace texmap::test {

TEST_CASE_TEMPLATE("noise is exactly 0 at the corners of its cubes, and at points that are none",
                   Real, float, double, long double) {
  Dice dice;
  for (int i = 0; i < 2000; ++i) {
    const auto whole = [&dice] { return static_cast<Real>(dice.within(-3000, 3000)); };
    CHECK(gradient_noise(Vec3<Real>{whole(), whole(), whole()}) == Real(0));
  }
  CHECK(gradient_noise(Vec3<Real>{Real(1e30L), Real(-1e30L), Real(0.5)}) ==
        gradient_noise(Vec3<Real>{Real(0), Real(0), Real(0.5)}));
  CHECK(std::isnan(gradient_noise(Vec3<Real>{std::numeric_limits<Real>::infinity(), 0, 0})));
}

TEST_CASE("noise repeats after 1024, and not after less") {
  Dice dice;
  int other = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3d p = number_cast<double>(number_cast<float>(point_within(dice, 8)));
    for (const Vec3d& period : {Vec3d{1024, 0, 0}, Vec3d{0, -1024, 0}, Vec3d{0, 0, 3072}})
      CHECK(gradient_noise(p + period) == gradient_noise(p));
    for (const Vec3d& half : {Vec3d{512, 0, 0}, Vec3d{0, 512, 0}, Vec3d{0, 0, 512}})
      other += gradient_noise(p + half) != gradient_noise(p) ? 1 : 0;
  }
  CHECK(other > 1490);
}

TEST_CASE("noise and its slopes go on across the faces between cubes, also where it repeats") {
  Dice dice;
  constexpr double step = 1e-6;
  for (int i = 0; i < 3000; ++i) {
    const Vec3d inside = point_within(dice, 3);
    const double face = dice.once_in(3) ? 1024 * dice.within(-1, 1) : dice.within(-1030, 1030);
    const auto along = [&, axis = dice.below(3)](double t) {
      return gradient_noise(axis == 0   ? Vec3d{face + t, inside.y, inside.z}
                            : axis == 1 ? Vec3d{inside.x, face + t, inside.z}
                                        : Vec3d{inside.x, inside.y, face + t});
    };
    const double before = (along(0) - along(-step)) / step,
                 behind = (along(step) - along(0)) / step;
    CHECK(std::abs(behind - before) < 1e-4);
    CHECK(std::abs(along(step) - along(-step)) < 4 * step);
  }
}

TEST_CASE("the slopes at corners have nothing to do with each other, neither have their parts") {
  const auto slope_at = [](const Vec3d& corner) {
    constexpr double step = 0x1p-20;
    const auto along = [&](const Vec3d& way) { return gradient_noise(corner + way * step) / step; };
    return Vec3d{along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})} * 1.5;
  };
  Dice dice;
  constexpr int count = 20000;
  double own = 0, others = 0, neighbors[3] = {};
  for (int i = 0; i < count; ++i) {
    const Vec3d corner = whole_point_within(dice, 600);
    const Vec3d slope = slope_at(corner);
    own += dot(slope, slope) / count;
    others += (slope.x * slope.y + slope.y * slope.z + slope.z * slope.x) / count;
    neighbors[0] += dot(slope, slope_at(corner + Vec3d{1, 0, 0})) / count;
    neighbors[1] += dot(slope, slope_at(corner + Vec3d{0, 1, 0})) / count;
    neighbors[2] += dot(slope, slope_at(corner + Vec3d{0, 0, 1})) / count;
  }
  CHECK(own == doctest::Approx(1).epsilon(0.02));
  for (const double sum : {others, neighbors[0], neighbors[1], neighbors[2]})
    CHECK(std::abs(sum) < 0.02);
}

TEST_CASE("an octave is half as strong and half as large, and moved") {
  const Vec3d p{0.3, -1.7, 2.2}, half{0.5, 0.5, 0.5};
  CHECK(fractal_noise(p, 1) == gradient_noise(p));
  CHECK(fractal_noise(p, 2) == gradient_noise(p) + gradient_noise(p * 2.0 + half) / 2);
}

TEST_CASE("marble without a bend is planes of stone and vein; a paint in space asks the point") {
  const Marble planes{.stone = {1, 0, 0}, .vein = {0, 0, 1}, .veins = 4, .bend = 0};
  CHECK(planes(Vec3d{0.125, 7, 0.3}).b == 0);
  CHECK(planes(Vec3d{0.25, -2, 0.9}).r == 0);
  CHECK(planes(Vec3d{0.1875, 5, 5}).r == 0.75);
  const Vec3d p{-0.5, 0.25, 0};
  const Hit<double> hit{{0, 1, 0}, p, p};
  CHECK(InSpace<Marble>{planes}(hit).b == planes(p).b);
  CHECK(InSpace<SolidCheckerboard>{{{1, 1, 1}, {0, 0, 0}, 1}}(hit).r == 0);
}

}  // namespace texmap::test
