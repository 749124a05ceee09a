// Tests of common/texture/projection_facts.hpp: distortion by duals against closed forms.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/dice.hpp"
#include "texture/projection_facts.hpp"

namespace texmap::test {
namespace {

constexpr double pi_here = std::numbers::pi;

std::vector<Vec3<double>> any_directions(int count) {
  Dice dice(9);
  std::vector<Vec3<double>> all;
  for (int i = 0; i < count; ++i) all.push_back(dice.direction<double>());
  return all;
}

/// The solid angle of a texel / the mean, derived by hand for each layout.
double area_by_hand(Projection projection, const Vec3<double>& n) {
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  const double depth = largest(n);
  switch (projection) {
    case Projection::equirect:
      return pi_here / 2 * std::hypot(n.x, n.z);
    case Projection::plane:
      return 1 / (2 * y);
    case Projection::cylinder:
    case Projection::equal_area:
      return 1;
    case Projection::cube:
      return 6 / pi_here * std::pow(depth, 3);
    case Projection::equi_angular: {
      // (1 + a^2)(1 + b^2) for the place (a, b) on the face; its depth is 1.
      const double product =
          (1 + square(x / depth)) * (1 + square(y / depth)) * (1 + square(z / depth)) / 2;
      return 3 * pi_here / 8 * std::pow(depth, 3) * product;
    }
    case Projection::octahedral:
      break;
  }
  return std::pow(x + y + z, 3) / pi_here;
}

}  // namespace

TEST_CASE("the solid angle of a texel by duals is the closed form to 1e-14") {
  for (const ProjectionFacts& facts : projections) {
    CAPTURE(std::string(facts.word));
    double worst = 0;
    for (const Vec3<double>& n : any_directions(20000)) {
      const double expected = area_by_hand(facts.projection, n);
      const double found = distortion(facts.projection, n).area;
      worst = std::max(worst, std::abs(found / expected - 1));
    }
    CHECK(worst <= 1e-14);
  }
}

TEST_CASE(
    "the stretch by duals is the closed form to 1e-14: 1 / cos, 1 / cos^2, 1 / y, 1 / depth; near "
    "1 too") {
  std::vector<Vec3<double>> places = any_directions(20000);
  for (const double near : {1e-12, 1e-9, 1e-6, 1e-3}) {  // stretches are 1 at these middles
    places.push_back(normalize(Vec3<double>{1, near, 0.7 * near}));
    places.push_back(normalize(Vec3<double>{near, 1, 0.7 * near}));
  }
  double worst[4] = {};
  for (const Vec3<double>& n : places) {
    const double cosine = std::hypot(n.x, n.z);
    const auto compare = [&](double& to, Projection projection, double expected) {
      to = std::max(to, std::abs(distortion(projection, n).stretch / expected - 1));
    };
    if (cosine > 0) compare(worst[0], Projection::equirect, 1 / cosine);
    if (cosine > 0) compare(worst[1], Projection::cylinder, 1 / square(cosine));
    if (n.y != 0) compare(worst[2], Projection::plane, 1 / std::abs(n.y));
    compare(worst[3], Projection::cube, 1 / largest(n));
  }
  for (const double off : worst) CHECK(off <= 1e-14);
}

TEST_CASE("at the poles an octahedral map does not stretch, at the middle of a face by sqrt 3") {
  CHECK(distortion(Projection::octahedral, normalize(Vec3<double>{1e-7, 1, 1e-7})).stretch ==
        doctest::Approx(1).epsilon(1e-5));
  CHECK(distortion(Projection::octahedral, normalize(Vec3<double>{1, 1, 1})).stretch ==
        doctest::Approx(std::sqrt(3.0)).epsilon(1e-12));
}

}  // namespace texmap::test
