// Chapter 12's symptoms: a picture as the sky, seen, mirrored and as light, with the word.
#include "scene/phong.hpp"
#include "support/symptoms.hpp"
#include "texture/environment.hpp"
#include "texture/sky_moments.hpp"
#include "texture/sky_sampler.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

/// A black sky of 8 x 4 texels with one white one.
Environment with_one_white(int column, int row, double degrees = 0) {
  LightImage map(8, 4);
  map.at(column, row) = {1, 1, 1};
  return Environment(map, TexelFilter::nearest, degrees);
}

double seen(const Environment& sky, const Vec3d& direction) {
  return sky(Ray<double>{{}, direction}).r;
}

}  // namespace

TEST_CASE("the sky's middle is at +x, +z lies to its left, and row 0 is above") {
  expect_number("column 4 of 8 just behind +x", seen(with_one_white(4, 1), {1, 0.1, -0.1}), 1, {},
                seen(with_one_white(4, 1), {1, 0.1, 0.1}) > 0
                    ? "the sky is mirrored: u runs the other way"
                    : "the sky begins at another place, or is upside down");
  expect_number("row 0 of 4 straight up", seen(with_one_white(4, 0), {0.1, 1, -0.01}), 1, {},
                seen(with_one_white(4, 0), {0.1, -1, -0.01}) > 0
                    ? "the sky is upside down: v runs the other way (flipped)"
                    : "the sky begins at another place");
}

TEST_CASE("turning the sky by 90 degrees carries what was at +z to +x") {
  // u = 1/4 is +z: columns 1 and 2 of 8 meet there.
  const Vec3d just_left{1, 0.1, 0.1};
  expect_number(
      "column 1 of 8, turned by 90 degrees, near +x",
      seen(with_one_white(1, 1, 90), just_left) + seen(with_one_white(2, 1, 90), just_left), 1,
      {{0, "the sky turns the other way"}});
}

TEST_CASE("a mirror sends a ray on at the same angle") {
  const Vec3d in = normalize(Vec3d{1, -1, 0});
  const Vec3d out = mirror(-in, Vec3d{0, 1, 0});
  expect_number("y after a mirror on the floor", out.y, -in.y,
                {{in.y, "the ray goes through the mirror"}});
  expect_number("x after a mirror on the floor", out.x, in.x,
                {{-in.x, "the ray goes back where it came from"}});
}

TEST_CASE("a white surface under a uniform sky of 1 sends out 1") {
  const Environment sky(LightImage(8, 4, {1, 1, 1}));
  expect_number("its light by the nine numbers", SkyMoments(sky).reflected(Vec3d{0, 1, 0}).r, 1,
                {{3.1415926535897932, "the division by pi is missing"},
                 {0.3183098861837907, "divided by pi once too often"}},
                "", 1e-3);
}

TEST_CASE("directions toward a lamp in the sky are as likely as it is bright") {
  const Environment sky = with_one_white(4, 1);
  const SkySampler sampler(sky);
  const Vec3d drawn = sampler.direction(sky, Point2<double>{0.5, 0.5}).direction;
  expect_number("the light in a direction that was drawn", seen(sky, drawn), 1,
                {{0, "drawn away from the light: half a texel off, mirrored or flipped"}});
}
