// Tests of common/scene/floor.hpp: distances to the floor. How exact they are, and that a point of
// the floor has its height to the bit, tests/extremes searches.
#include <doctest.h>

#include <string>

#include "scene/floor.hpp"

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
      {"from above, aslant", 0, {{1, 3, 5}, {2, -1, -7}}, 3},
      {"from below", 0, {{0, -2, 0}, {0, 1, 0}}, 2},
      {"a floor higher up", 1.5, {{0, 2, 0}, {0, -1, 0}}, Real(0.5)},
      {"from above, upward", 0, {{0, 2, 0}, {0, 1, 0}}, miss},
      {"along it, above", 0, {{0, 2, 0}, {1, 0, 0}}, miss},
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

}  // namespace
}  // namespace texmap::test
