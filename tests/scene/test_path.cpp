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

/// A path as page 07 shows it, in plain C++.
struct PlainPath {
  const std::vector<Object>& objects;
  const GradientSky& sky;
  Planned<double>& random;

  Rgb light(const Ray<double>& ray, int bounces) {
    const Nearest<double> nearest = find_nearest(objects, ray);
    if (nearest.distance == infinity<double>()) return sky(ray);
    if (bounces == 0) return {0, 0, 0};
    const Object& object = objects[static_cast<std::size_t>(nearest.index)];
    const Hit<double> hit = hit_at(object.shape, ray, nearest.distance);
    const Vec3<double> direction = cosine_direction(hit.normal, random.next_2d());
    return object.paint(hit) * light({hit.outside, direction}, bounces - 1);
  }
};

TEST_CASE(
    "one sphere alone is lit as it is next to one that nobody sees; without a sphere there is "
    "sky") {
  const std::vector<Object> none, one = {{{{0.5, 0.25, -6}, 2}, {{0.5, 0.25, 1}}}};
  std::vector<Object> both = one;
  both.push_back({{{0, 0, 1e6}, 1e-3}, {{0, 0, 0}}});
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    const Ray<double> ray{{}, {dice.between(-1, 1), dice.between(-1, 1), -2}};
    const Point2<double> sample{dice.between(0, 1), dice.between(0, 1)};
    for (const GradientSky& sky : {plain_sky, fading_sky}) {
      Planned<double> alone{{sample}}, beside{{sample}};
      const Color<double> light = light_along(both, ray, sky, 1, beside);
      const auto off = [&](const std::vector<Object>& objects) {
        const Color<double> apart = light_along(objects, ray, sky, 1, alone) + light * -1.0;
        return std::max({abs(apart.r), abs(apart.g), abs(apart.b)});
      };
      REQUIRE(off(one) < 1e-14);
      REQUIRE(alone.used == (sky.is_constant() ? 0 : beside.used));
      if (beside.used == 0) REQUIRE(off(none) < 1e-14);
    }
  }
}

TEST_CASE("a path in plain C++, as page 07 shows it, brings the same light") {
  const std::vector<Object> globe_on_ground = {{{{0, 0, 0}, 2}, {{0.5, 0.25, 1}}},
                                               {{{0, -1002, 0}, 1000}, {{0.25, 1, 0.5}}}};
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    const Vec3<double> target{dice.between(-4, 4), dice.between(-3, 2), 0};
    const Ray<double> ray{{0, 1.5, 12}, normalize(target - Vec3<double>{0, 1.5, 12})};
    Planned<double> random;
    for (int k = 0; k < 3; ++k) random.pairs.push_back({dice.between(0, 1), dice.between(0, 1)});
    Planned<double> same = random;
    const Rgb light = light_along(globe_on_ground, ray, fading_sky, 3, random);
    const Rgb plain = PlainPath{globe_on_ground, fading_sky, same}.light(ray, 3);
    REQUIRE(abs(light.r - plain.r) + abs(light.g - plain.g) + abs(light.b - plain.b) < 1e-12);
    REQUIRE(random.used == same.used);
  }
}

}  // namespace
}  // namespace texmap::test
