// A hit with derivatives along the surface.
#include "scene/steps.hpp"

#include <doctest.h>

#include "scene/sphere.hpp"
#include "support/dice.hpp"

using namespace texmap;
using namespace texmap::test;

TEST_CASE("on a sphere, the normal with steps is what the point with steps gives") {
  Dice dice(1);
  for (const double radius : {0.25, 1.0, 40.0}) {
    for (int i = 0; i < 300; ++i) {
      const Vec3d normal = dice.direction<double>();
      const Hit<double> hit{normal, normal * radius, {}, {}};
      const Frame<double> frame = frame_about(normal);
      const Hit<Dual<double>> moving = with_steps(hit, frame, 1 / radius);
      const Vec3<Dual<double>> expected = normalize(moving.point);
      CHECK(largest(dx_of(moving.normal) - dx_of(expected)) < 1e-15 / radius);
      CHECK(largest(dy_of(moving.normal) - dy_of(expected)) < 1e-15 / radius);
      // One step of length 1 along each vector of the frame.
      CHECK(largest(dx_of(moving.point) - frame.right) == 0);
      CHECK(largest(dy_of(moving.point) - frame.up) == 0);
      CHECK(moving.normal.x.value == normal.x);
    }
  }
}
