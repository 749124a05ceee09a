// Tests of common/scene/nearest.hpp: the first object along a ray, and occlusion.
#include <doctest.h>

#include <algorithm>
#include <vector>

#include "math/color.hpp"
#include "number/kinds/pack.hpp"
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
  std::vector<int> order = {0, 1, 2, 3};
  int orders = 0;
  do {
    std::vector<Thing> shuffled;
    for (const int i : order) shuffled.push_back(things[static_cast<std::size_t>(i)]);
    const Nearest<Real> nearest = find_nearest(shuffled, along_z<Real>);
    REQUIRE(nearest.distance == Real(14.5));
    REQUIRE(shuffled[static_cast<std::size_t>(nearest.index)].mark == 3);
    ++orders;
  } while (std::next_permutation(order.begin(), order.end()));
  CHECK(orders == 24);
}

TEST_CASE_TEMPLATE("a ray that meets nothing has no nearest object", Real, float, double,
                   long double) {
  for (const Ray<Real>& ray :
       {Ray<Real>{{0, 0, 20}, {0, 0, 1}}, Ray<Real>{{0, 3, 20}, {0, 0, -1}}}) {
    const Nearest<Real> nearest = find_nearest(row_of_things(), ray);
    CHECK(nearest.distance == infinity<Real>());
    CHECK(nearest.index == Real(-1));
  }
  CHECK(find_nearest(std::vector<Thing>{}, along_z<Real>).index == Real(-1));
}

TEST_CASE_TEMPLATE("objects behind the origin do not count", Real, float, double, long double) {
  const Nearest<Real> nearest = find_nearest(row_of_things(), Ray<Real>{{0, 0, 3}, {0, 0, -1}});
  CHECK(nearest.index == Real(0));
  CHECK(nearest.distance == Real(2));
}

TEST_CASE_TEMPLATE("of two objects in one place the first in the list is seen", Real, float, double,
                   long double) {
  const std::vector<Thing> twins = {{{{0, 0, 0}, 1}, 1}, {{{0, 0, 0}, 1}, 2}};
  CHECK(find_nearest(twins, along_z<Real>).index == Real(0));
}

TEST_CASE_TEMPLATE(
    "an object is in the way if it begins before the distance, and not if it begins there or "
    "beyond",
    Real, float, double, long double) {
  const auto things = row_of_things();
  CHECK(is_occluded(things, along_z<Real>, Real(15)));
  CHECK(is_occluded(things, along_z<Real>, infinity<Real>()));
  CHECK_FALSE(is_occluded(things, along_z<Real>, Real(14.5)));
  CHECK_FALSE(is_occluded(things, along_z<Real>, Real(14)));
  CHECK_FALSE(is_occluded(things, Ray<Real>{{0, 0, 20}, {0, 0, 1}}, infinity<Real>()));
  CHECK_FALSE(is_occluded(std::vector<Thing>{}, along_z<Real>, infinity<Real>()));
  CHECK(is_occluded(things, Ray<Real>{{0, 0, -20}, {0, 0, 1}}, Real(9)));
}

TEST_CASE_TEMPLATE("the color along a ray is that of the first object, shaded once at its hit",
                   Real, float, double, long double) {
  int asked = 0;
  const auto background = [](const Ray<Real>&) { return gray(Real(0.25)); };
  const auto shade = [&asked](const Thing& thing, const Hit<Real>& hit) {
    ++asked;
    return Color<Real>{static_cast<Real>(thing.mark), hit.point.z, hit.normal.z};
  };
  const Color<Real> color = color_along(row_of_things(), along_z<Real>, background, shade);
  CHECK(color.r == Real(3));
  CHECK(abs(color.g - Real(5.5)) <= Real(8) * std::numeric_limits<Real>::epsilon());
  CHECK(color.b == Real(1));
  CHECK(asked == 1);
}

TEST_CASE_TEMPLATE("a ray that meets nothing has the background's color and asks no object", Real,
                   float, double, long double) {
  int asked = 0;
  const auto background = [](const Ray<Real>& ray) { return gray(ray.direction.z); };
  const auto shade = [&asked](const Thing&, const Hit<Real>&) {
    ++asked;
    return gray(Real(0));
  };
  const Color<Real> color =
      color_along(row_of_things(), Ray<Real>{{0, 0, 20}, {0, 0, 1}}, background, shade);
  CHECK(color.r == Real(1));
  CHECK(color.g == Real(1));
  CHECK(color.b == Real(1));
  CHECK(asked == 0);
}

TEST_CASE_TEMPLATE("lanes that see different objects get their own colors", T, float, double) {
  using Many = Pack<T>;
  const auto things = row_of_things();
  // Even lanes look at the row of spheres; odd ones at the sphere next to it, or past everything.
  for (const double beside : {8.0, 4.0}) {
    const auto x = [beside](std::size_t i) { return i % 2 == 0 ? T(0) : static_cast<T>(beside); };
    const Ray<Many> rays{{from_lanes<Many>(x), Many(0), Many(20)}, {Many(0), Many(0), Many(-1)}};
    const auto background = [](const Ray<Many>&) { return gray(Many(9)); };
    int asked = 0;
    const auto shade = [&asked](const Thing& thing, const Hit<Many>& hit) {
      ++asked;
      return Color<Many>{Many(thing.mark), hit.normal.z, hit.point.x};
    };
    const Color<Many> colors = color_along(things, rays, background, shade);
    const bool met = beside == 8.0;
    CHECK(asked == (met ? 2 : 1));
    for (std::size_t i = 0; i < lanes<Many>; ++i) {
      CHECK(lane(colors.r, i) == (i % 2 == 0 ? T(3) : met ? T(4) : T(9)));
      CHECK(lane(colors.g, i) == (i % 2 == 0 || met ? T(1) : T(9)));
      CHECK(lane(colors.b, i) == (i % 2 == 0 ? T(0) : met ? T(8) : T(9)));
    }
    const auto hidden = is_occluded(things, rays, Many(17));
    const Many shown = select(hidden, Many(1), Many(0));
    for (std::size_t i = 0; i < lanes<Many>; ++i)
      CHECK(lane(shown, i) == (i % 2 == 0 ? T(1) : T(0)));
  }
}

}  // namespace
}  // namespace texmap::test
