// Tests of common/texture/projection_facts.hpp: distortion by duals against closed forms.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "number/kinds/pack.hpp"
#include "support/dice.hpp"
#include "texture/projection_facts.hpp"

namespace texmap::test {
namespace {

constexpr double pi_here = static_cast<double>(pi_digits);

std::vector<Vec3<double>> any_directions(int count) {
  Dice dice(9);
  std::vector<Vec3<double>> all;
  while (static_cast<int>(all.size()) < count) {
    const Vec3<double> p{dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1)};
    if (dot(p, p) <= 1 && dot(p, p) > 0.01) all.push_back(normalize(p));
  }
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
      // (1 + a^2)(1 + b^2) for the place (a, b) on the face, whose depth is 1.
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

TEST_CASE("the solid angle of a texel by duals is the closed form to 1e-12") {
  for (const ProjectionFacts& facts : projections) {
    CAPTURE(std::string(facts.word));
    double worst = 0;
    for (const Vec3<double>& n : any_directions(20000)) {
      const double expected = area_by_hand(facts.projection, n);
      const double found = distortion(facts.projection, n).area;
      worst = std::max(worst, std::abs(found / expected - 1));
    }
    MESSAGE(std::string(facts.word) << ": " << worst << " of itself");
    CHECK(worst <= 1e-12);
  }
  // The sine forgotten, or taken twice, would be seen.
  const Vec3<double> n = normalize(Vec3<double>{1, 1, 1});
  CHECK(std::abs(distortion(Projection::equirect, n).area - pi_here / 2) > 0.1);
}

TEST_CASE("the stretch by duals is the closed form: 1 / cos, 1 / cos^2, 1 / y, 1 / depth") {
  for (const Vec3<double>& n : any_directions(20000)) {
    const double cosine = std::hypot(n.x, n.z);
    if (cosine < 0.01 || std::abs(n.y) < 0.01) continue;
    const auto stretch = [&](Projection projection) { return distortion(projection, n).stretch; };
    // A root takes half the digits where the stretch is near 1.
    const auto close = [](double a, double b) { return std::abs(a / b - 1) <= 1e-6; };
    REQUIRE(close(stretch(Projection::equirect), 1 / cosine));
    REQUIRE(close(stretch(Projection::cylinder), 1 / square(cosine)));
    REQUIRE(close(stretch(Projection::plane), 1 / std::abs(n.y)));
    REQUIRE(close(stretch(Projection::cube), 1 / largest(n)));
  }
}

TEST_CASE("at the poles an octahedral map does not stretch, at the middle of a face by sqrt 3") {
  CHECK(distortion(Projection::octahedral, normalize(Vec3<double>{1e-7, 1, 1e-7})).stretch ==
        doctest::Approx(1).epsilon(1e-5));
  CHECK(distortion(Projection::octahedral, normalize(Vec3<double>{1, 1, 1})).stretch ==
        doctest::Approx(std::sqrt(3.0)).epsilon(1e-12));
}

TEST_CASE("packs find the same distortion, but for the rounding of their arc tangent") {
  for (const ProjectionFacts& facts : projections) {
    for (const Vec3<double>& n : any_directions(50)) {
      const auto single = distortion(facts.projection, n);
      const auto many = distortion(facts.projection, number_cast<Pack<double>>(n));
      CHECK(lane(many.area, 0) == doctest::Approx(single.area).epsilon(1e-12));
      CHECK(lane(many.stretch, 0) == doctest::Approx(single.stretch).epsilon(1e-7));
    }
  }
}

}  // namespace texmap::test
