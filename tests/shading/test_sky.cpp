// Tests of common/shading/sky.hpp: the gradient that a ray sees which hits nothing.
#include <doctest.h>

#include "pack.hpp"
#include "sky.hpp"

namespace texmap {
namespace {

const GradientSky sky{.below = {1, 0.5, 0}, .above = {0.5, 0.25, 1}};

TEST_CASE_TEMPLATE("the sky has its colors straight down, straight up and half way between", Real, float, double, long double) {
  struct Row {
    double height, r, g, b;
  };
  const Row table[] = {
      {-1, 1, 0.5, 0}, {1, 0.5, 0.25, 1}, {0, 0.75, 0.375, 0.5}, {0.5, 0.625, 0.3125, 0.75}, {-0.5, 0.875, 0.4375, 0.25}};
  for (const Row& row : table) {
    CAPTURE(row.height);
    const Color<Real> color = sky(Ray<Real>{{3, 4, 5}, {0, static_cast<Real>(row.height), 0}});
    CHECK(color.r == static_cast<Real>(row.r));
    CHECK(color.g == static_cast<Real>(row.g));
    CHECK(color.b == static_cast<Real>(row.b));
  }
}

TEST_CASE_TEMPLATE("only the height of the line of sight matters", Real, float, double, long double) {
  const Color<Real> color = sky(Ray<Real>{{0, 0, 0}, {Real(0.8L), Real(0.5), Real(0.1L)}});
  const Color<Real> other = sky(Ray<Real>{{9, -9, 9}, {Real(-0.3L), Real(0.5), Real(0.7L)}});
  CHECK(color.r == other.r);
  CHECK(color.g == other.g);
  CHECK(color.b == other.b);
}

TEST_CASE_TEMPLATE("a sky of one color stays within an ulp of it", Real, float, double, long double) {
  const GradientSky plain{.below = {0.3, 0.6, 0.9}, .above = {0.3, 0.6, 0.9}};
  for (int i = -1000; i <= 1000; ++i) {
    const Color<Real> color = plain(Ray<Real>{{0, 0, 0}, {0, static_cast<Real>(i) / Real(1000), 0}});
    REQUIRE(abs(color.r - Real(0.3)) <= std::numeric_limits<Real>::epsilon());
    REQUIRE(abs(color.g - Real(0.6)) <= std::numeric_limits<Real>::epsilon());
    REQUIRE(abs(color.b - Real(0.9)) <= std::numeric_limits<Real>::epsilon());
  }
}

#ifdef TEXMAP_HAVE_PACKS
TEST_CASE_TEMPLATE("each lane of a pack sees its own sky", T, float, double) {
  const auto height = from_lanes<Pack<T>>([](std::size_t i) { return static_cast<T>(i) / T(20) - T(0.3); });
  const Color<Pack<T>> colors = sky(Ray<Pack<T>>{{}, {Pack<T>(0), height, Pack<T>(0)}});
  for (std::size_t i = 0; i < lanes<Pack<T>>; ++i) {
    const Color<T> color = sky(Ray<T>{{}, {0, lane(height, i), 0}});
    CHECK(lane(colors.r, i) == color.r);
    CHECK(lane(colors.g, i) == color.g);
    CHECK(lane(colors.b, i) == color.b);
  }
}
#endif

}  // namespace
}  // namespace texmap
