// Tests of scene/path.hpp: the light of paths with known turns.
#include <doctest.h>
#include <algorithm>

#include <cmath>
#include <vector>

#include "scene/paint.hpp"
#include "scene/path.hpp"
#include "scene/sky.hpp"
#include "support/dice.hpp"

namespace texmap::test {
namespace {

using Object = Painted<Solid>;

/// The pairs that a path is to get, one after the other; beyond the last none is there.
template <class Real>
struct Planned {
  std::vector<Point2<Real>> pairs;
  std::size_t used = 0;
  const Point2<Real>& next_2d() { return pairs.at(used++); }
};

/// Numbers that scatter a path along the normal, and nearly along the surface.
template <class Real>
const Point2<Real> straight{Real(0.5) - Real(0x1p-25), Real(0.5) - Real(0x1p-25)};
template <class Real>
const Point2<Real> aside{Real(1) - Real(0x1p-24), Real(0.5) - Real(0x1p-25)};

/// Two spheres on the z axis, above and below the origin. A path that leaves them along their
/// normals goes to and fro forever. Albedos are powers of two, so that nothing rounds.
const std::vector<Object> two_mirrors = {{{{0, 0, -5}, 1}, {{0.5, 0.25, 1}}},
                                         {{{0, 0, 5}, 1}, {{0.25, 1, 0.5}}}};
const GradientSky plain_sky{.below = {1, 0.5, 0.25}, .above = {1, 0.5, 0.25}};
const GradientSky fading_sky{.below = {1, 1, 1}, .above = {0.5, 0.75, 1}};

template <class Real>
bool is(const Color<Real>& color, double r, double g, double b) {
  return color.r == Real(r) && color.g == Real(g) && color.b == Real(b);
}

TEST_CASE_TEMPLATE(
    "a path brings the sky's light times every albedo on its way, and none if it bounces too often",
    Real, float, double, long double) {
  for (int needed = 1; needed <= 5; ++needed) {
    Planned<Real> plan;
    for (int bounce = 1; bounce < needed; ++bounce) plan.pairs.push_back(straight<Real>);
    plan.pairs.push_back(aside<Real>);
    const int at_first = (needed + 1) / 2;  // of the spheres the first is met one time more
    const int at_second = needed / 2;
    for (int bounces = 1; bounces <= 6; ++bounces) {
      CAPTURE(needed);
      CAPTURE(bounces);
      Planned<Real> random = plan;
      const Ray<Real> ray{{0, 0, 0}, {0, 0, -3}};
      const Color<Real> light = light_along(two_mirrors, ray, plain_sky, bounces, random);
      if (bounces < needed) {
        CHECK(is(light, 0, 0, 0));
        CHECK(random.used == static_cast<std::size_t>(bounces));
      } else {
        CHECK(is(light, std::pow(0.5, at_first) * std::pow(0.25, at_second),
                 std::pow(0.25, at_first) * 0.5, std::pow(0.5, at_second) * 0.25));
        CHECK(random.used == static_cast<std::size_t>(needed));
      }
    }
  }
}

TEST_CASE("one sphere alone is lit as it is next to one that nobody sees") {
  const std::vector<Object> one = {{{{0.5, 0.25, -6}, 2}, {{0.5, 0.25, 1}}}};
  std::vector<Object> both = one;
  both.push_back({{{0, 0, 1e6}, 1e-3}, {{0, 0, 0}}});
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    const Ray<double> ray{{}, {dice.between(-1, 1), dice.between(-1, 1), -2}};
    const Point2<double> sample{dice.between(0, 1), dice.between(0, 1)};
    for (const GradientSky& sky : {plain_sky, fading_sky}) {
      Planned<double> alone{{sample}}, beside{{sample}};
      const Color<double> off =
          light_along(one, ray, sky, 1, alone) + light_along(both, ray, sky, 1, beside) * -1.0;
      REQUIRE(std::max({abs(off.r), abs(off.g), abs(off.b)}) < 1e-14);
      REQUIRE(alone.used == (sky.is_constant() ? 0 : beside.used));
    }
  }
  Planned<double> none;
  const Ray<double> up{{}, {0, 3, 4}};  // to 4/5 of the way from below to above, at any length
  CHECK(light_along(std::vector<Object>{}, up, fading_sky, 1, none).g == doctest::Approx(0.8));
}

}  // namespace
}  // namespace texmap::test
