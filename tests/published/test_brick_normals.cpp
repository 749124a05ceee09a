// The daily exercise's bricks: what is wrong with them.
#include "published/brick_normals.hpp"

#include <doctest.h>

#include "published/uv.hpp"
#include "support/dice.hpp"
#include "texture/bump.hpp"
#include "texture/conventions.hpp"

using namespace texmap;
using namespace texmap::test;

TEST_CASE("19 % of the bricks' normals point into the globe") {
  // A grid of 1200 x 1200 holds each brick's 100 x 200 points; no point lies on an edge.
  int inward = 0, outward = 0;
  for (int row = 0; row < 1200; ++row) {
    for (int column = 0; column < 1200; ++column) {
      const Vec3d normal = published::brick_normal({(column + 0.5) / 1200, (row + 0.5) / 1200});
      inward += normal.z == -1 ? 1 : 0;
      outward += normal.z > 0.98 ? 1 : 0;
    }
  }
  CHECK(inward + outward == 1200 * 1200);
  CHECK(inward == doctest::Approx(0.19 * 1200 * 1200).epsilon(1e-12));
}

TEST_CASE("the bricks' tangents run along -dP/du and -dP/dv: a bump comes out as a dent") {
  Dice dice(1);
  for (int i = 0; i < 500; ++i) {
    const Vec3d normal = dice.direction<double>();
    if (std::abs(normal.y) > 0.999) continue;
    const Frame<double> frame = frame_about(normal);
    const Hit<double> hit{normal, normal, normal, normal};
    const Uv<Dual<double>> uv = uv_of(Convention::daily, with_steps(hit, frame, 1.0).normal);
    const TangentFrame<double> by_uv =
        tangents(TangentRule::from_uv, normal, point_by_uv(frame, uv));
    const TangentFrame<double> published = published::brick_tangents(normal);
    CHECK(largest(published.tangent + by_uv.tangent) < 1e-12);
    CHECK(largest(published.bitangent + by_uv.bitangent) < 1e-12);
    // The coordinates are the exercise's.
    const Uv<double> its = published::uv_daily(normal);
    CHECK(std::abs(its.u - uv.u.value) < 1e-12);
    CHECK(std::abs(its.v - uv.v.value) < 1e-7);
  }
}
