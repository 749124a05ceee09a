// Tests of common/scene/nearest.hpp: the first object along a ray, and occlusion.
#include <doctest.h>

#include <algorithm>
#include <vector>

#include "scene/nearest.hpp"

namespace texmap::test {
namespace {

struct Thing {
  Sphere<> shape;
  double mark = 0;
};

/// Three spheres one behind the other on the z axis, and one off the axis.
std::vector<Thing> row_of_things() {
  return {{{{0, 0, 0}, 1}, 1}, {{{0, 0, -10}, 2}, 2}, {{{0, 0, 5}, 0.5}, 3}, {{{8, 0, 0}, 1}, 4}};
}

template <class Real>
const Ray<Real> along_z{{0, 0, 20}, {0, 0, -1}};

TEST_CASE_TEMPLATE("the nearest object is found wherever it is in the list", Real, float, double,
                   long double) {
  std::vector<Thing> things = row_of_things();
  for (std::size_t i = 0; i < things.size(); ++i) {
    const Nearest<Real> nearest = find_nearest(things, along_z<Real>);
    REQUIRE(nearest.distance == Real(14.5));
    REQUIRE(things[static_cast<std::size_t>(nearest.index)].mark == 3);
    std::rotate(things.begin(), things.begin() + 1, things.end());
  }
  // What is behind the origin does not count; of two in one place the first in the list is seen.
  const Nearest<Real> beyond = find_nearest(things, Ray<Real>{{0, 0, 3}, {0, 0, -1}});
  CHECK(beyond.index == Real(0));
  CHECK(beyond.distance == Real(2));
  const std::vector<Thing> twins = {{{{0, 0, 0}, 1}, 1}, {{{0, 0, 0}, 1}, 2}};
  CHECK(find_nearest(twins, along_z<Real>).index == Real(0));
  const Nearest<Real> none = find_nearest(things, Ray<Real>{{0, 3, 20}, {0, 0, -1}});
  CHECK(none.distance == infinity<Real>());
  CHECK(none.index == Real(-1));
}

TEST_CASE_TEMPLATE(
    "an object is in the way if it begins before the distance, and not if it begins there or "
    "beyond",
    Real, float, double, long double) {
  const auto things = row_of_things();
  CHECK(is_occluded(things, along_z<Real>, Real(15)));
  CHECK(is_occluded(things, along_z<Real>, infinity<Real>()));
  CHECK_FALSE(is_occluded(things, along_z<Real>, Real(14.5)));
  CHECK_FALSE(is_occluded(things, Ray<Real>{{0, 0, 20}, {0, 0, 1}}, infinity<Real>()));
}

}  // namespace
}  // namespace texmap::test
