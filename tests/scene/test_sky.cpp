// Tests of common/scene/sky.hpp: the gradient that a ray sees which hits nothing.
#include <doctest.h>

#include "scene/sky.hpp"

namespace texmap::test {
namespace {

const GradientSky sky{.below = {1, 0.5, 0}, .above = {0.5, 0.25, 1}};

TEST_CASE_TEMPLATE("the sky has its colors straight down, straight up and half way between", Real,
                   float, double, long double) {
  struct Row {
    double height, r, g, b;
  };
  const Row table[] = {{-1, 1, 0.5, 0},
                       {1, 0.5, 0.25, 1},
                       {0, 0.75, 0.375, 0.5},
                       {0.5, 0.625, 0.3125, 0.75},
                       {-0.5, 0.875, 0.4375, 0.25}};
  for (const Row& row : table) {
    CAPTURE(row.height);
    const Color<Real> color = sky(Ray<Real>{{3, 4, 5}, {0, static_cast<Real>(row.height), 0}});
    CHECK(color.r == static_cast<Real>(row.r));
    CHECK(color.g == static_cast<Real>(row.g));
    CHECK(color.b == static_cast<Real>(row.b));
  }
}

TEST_CASE_TEMPLATE("a sky of one color has it to the bit", Real, float, double, long double) {
  const GradientSky plain{.below = {0.3, 0.6, 0.9}, .above = {0.3, 0.6, 0.9}};
  CHECK(plain.is_constant());
  CHECK_FALSE(sky.is_constant());
  CHECK_FALSE(GradientSky{.below = {1, 1, 1}, .above = {1, 1, 0.5}}.is_constant());
  CHECK(plain(Ray<Real>{{0, 0, 0}, {0, Real(0.1L), 0}}).g == Real(0.6));
}

}  // namespace
}  // namespace texmap::test
