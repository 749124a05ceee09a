// Tests of common/scene/floor.hpp: the floor, and what its exact height is good for.
#include <doctest.h>

#include <cmath>

#include "scene/floor.hpp"
#include "support/dice.hpp"
#include "support/lanes.hpp"
#include "texture/solid_checkerboard.hpp"

namespace texmap::test {
namespace {

TEST_CASE_TEMPLATE("distances to the floor obey their table: from above, below, along it and on it",
                   Real, float, double, long double) {
  const Real miss = infinity<Real>();
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  struct Row {
    const char* what;
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
}

TEST_CASE_TEMPLATE("a hit lies on the floor to the bit, and along the ray", Real, float, double,
                   long double) {
  Dice dice;
  for (int i = 0; i < 10000; ++i) {
    const Floor floor{dice.between(-1, 1)};
    const Ray<Real> ray{{Real(dice.between(-1, 1)), Real(1.5), Real(dice.between(-1, 1))},
                        {Real(dice.between(-1, 1)), Real(-1), Real(dice.between(-1, 1))}};
    const Real distance = distance_to(floor, ray);
    REQUIRE(distance < infinity<Real>());
    const Vec3<Real> p = point_on(floor, ray, distance);
    REQUIRE(p.y == Real(floor.height));
    REQUIRE(p.x == ray.origin.x + ray.direction.x * distance);
    REQUIRE(p.z == ray.origin.z + ray.direction.z * distance);
  }
}

TEST_CASE("a floor is at 0 unless told otherwise") { CHECK(Floor{}.height == 0); }

/// A ray from above the floor down to it, as a camera sends it.
template <class Real>
Ray<Real> ray_down(Dice& dice) {
  return {{Real(0.3), Real(1.7), Real(4.1)},
          {Real(dice.between(-1, 1)), Real(-0.6 + 0.5 * dice.between(-1, 1)), Real(-1)}};
}

/// True where (x, z) is in an even square of a board on the floor; by integers, not our
/// checkerboard.
template <class Real>
bool even_square(Real x, Real z) {
  const auto column = static_cast<std::int64_t>(std::floor(static_cast<long double>(x)));
  const auto row = static_cast<std::int64_t>(std::floor(static_cast<long double>(z)));
  return (column % 2 == 0) == (row % 2 == 0);
}

const SolidCheckerboard board{{1, 1, 1}, {0, 0, 0}, 1};

TEST_CASE_TEMPLATE(
    "P35: on the floor y = 0 a checkerboard in space is the one in the plane, for 10000 rays", Real,
    float, double, long double) {
  int wrong = 0;
  int even = 0;
  Dice dice;
  for (int i = 0; i < 10000; ++i) {
    const Ray<Real> ray = ray_down<Real>(dice);
    const Vec3<Real> p = point_on(Floor{0}, ray, distance_to(Floor{0}, ray));
    const bool is_white = board(p).r == Real(1);
    if (is_white != even_square(p.x, p.z)) ++wrong;
    if (is_white) ++even;
  }
  CHECK(wrong == 0);
  CHECK(even > 4000);  // both colors are there
  CHECK(even < 6000);
}

TEST_CASE_TEMPLATE(
    "P35: with the height that rounding left, hundreds of the 10000 show the color of the cubes "
    "below",
    Real, float, double) {
  int wrong = 0;
  Dice dice;
  for (int i = 0; i < 10000; ++i) {
    const Ray<Real> ray = ray_down<Real>(dice);
    const Vec3<Real> p = ray.origin + ray.direction * distance_to(Floor{0}, ray);
    if ((board(p).r == Real(1)) != even_square(p.x, p.z)) ++wrong;
  }
  MESSAGE("wrong: " << wrong << " of 10000");
  CHECK(wrong > 450);
}

TEST_CASE_TEMPLATE("a pack meets the floor in each lane where a single ray meets it", T, float,
                   double) {
  using Many = Pack<T>;
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    const Ray<Many> rays{any_vectors<Many>(dice, -1, 1), any_vectors<Many>(dice, -1, 1)};
    check_each_lane<Many>(
        []<class Real>(const Ray<Real>& ray) {
          const Floor floor{0.25};
          const Real distance = distance_to(floor, ray);
          const Mask<Real> met = distance < infinity<Real>();  // a miss has no point
          return std::tuple(distance, point_on(floor, ray, select(met, distance, Real(1))));
        },
        rays);
  }
}

}  // namespace
}  // namespace texmap::test
