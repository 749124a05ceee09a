// Tests of common/scene/floor.hpp: the floor, and what its exact height is good for.
#include <doctest.h>

#include <cmath>
#include <string>

#include "scene/floor.hpp"
#include "support/dice.hpp"
#include "texture/solid_checkerboard.hpp"

namespace texmap::test {
namespace {

TEST_CASE_TEMPLATE("distances to the floor obey their table: from above, below, along it and on it",
                   Real, float, double, long double) {
  const Real miss = infinity<Real>();
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  struct Row {
    std::string what;
    double height;
    Ray<Real> ray;
    Real distance;
  };
  const Row table[] = {
      {"from above", 0, {{0, 2, 0}, {0, -1, 0}}, 2},
      {"from above, a long direction", 0, {{0, 2, 0}, {0, -4, 0}}, Real(0.5)},
      {"from above, aslant", 0, {{1, 3, 5}, {2, -1, -7}}, 3},
      {"from below", 0, {{0, -2, 0}, {0, 1, 0}}, 2},
      {"a floor higher up", 1.5, {{0, 2, 0}, {0, -1, 0}}, Real(0.5)},
      {"a floor below 0", -3, {{0, 2, 0}, {0, -1, 0}}, 5},
      {"from above, upward", 0, {{0, 2, 0}, {0, 1, 0}}, miss},
      {"from below, downward", 0, {{0, -2, 0}, {0, -1, 0}}, miss},
      {"along it, above", 0, {{0, 2, 0}, {1, 0, 0}}, miss},
      {"along it, below", 0, {{0, -2, 0}, {1, 0, 0}}, miss},
      {"along it, above, with a minus zero", 0, {{0, 2, 0}, {1, -Real(0), 0}}, miss},
      {"on it, along it", 0, {{0, 0, 0}, {1, 0, 0}}, miss},
      {"on it, downward", 0, {{0, 0, 0}, {0, -1, 0}}, miss},
      {"on it, upward", 2, {{0, 2, 0}, {0, 1, 0}}, miss},
      {"without a direction", 0, {{0, 2, 0}, {0, 0, 0}}, miss},
      {"from a height that is no number", 0, {{0, nan, 0}, {0, -1, 0}}, miss},
      {"with a direction that is no number", 0, {{0, 2, 0}, {0, nan, 0}}, miss},
  };
  for (const Row& row : table) {
    CAPTURE(row.what);
    CHECK(distance_to(Floor{row.height}, row.ray) == row.distance);
  }
  CHECK(Floor{}.height == 0);
}

TEST_CASE_TEMPLATE(
    "P35: on the floor a checkerboard in space is the one in the plane, but not with the height "
    "that rounding left",
    Real, float, double) {
  const SolidCheckerboard board{{1, 1, 1}, {0, 0, 0}, 1};
  int white = 0, wrong_by_rounding = 0;
  Dice dice;
  for (int i = 0; i < 10000; ++i) {
    const Ray<Real> ray{{Real(0.3), Real(1.7), Real(4.1)},
                        {Real(dice.between(-1, 1)), Real(dice.between(-1.1, -0.1)), Real(-1)}};
    const Real distance = distance_to(Floor{0}, ray);
    const Vec3<Real> rounded = ray.origin + ray.direction * distance;
    const Vec3<Real> p = point_on(Floor{0}, ray, distance);
    REQUIRE(p.x == rounded.x);
    REQUIRE(p.z == rounded.z);
    // In the plane by whole numbers, not by our checkerboard.
    const auto cell = [](Real x) { return static_cast<int>(std::floor(x)); };
    const bool even = (cell(p.x) + cell(p.z)) % 2 == 0;
    REQUIRE((board(p).r == Real(1)) == even);
    white += even ? 1 : 0;
    wrong_by_rounding += (board(rounded).r == Real(1)) != even ? 1 : 0;
  }
  CHECK(white > 4000);  // both colors are there
  CHECK(white < 6000);
  CHECK(wrong_by_rounding > 450);
}

}  // namespace
}  // namespace texmap::test
