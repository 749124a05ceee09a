// Chapter 09's symptoms: footprints, pyramid levels and filters, with the word for a mistake.
#include "support/symptoms.hpp"
#include "texture/bilinear.hpp"
#include "texture/filters.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

/// A row of four texels: red 0, 1/4, 1/2, 3/4.
LightImage steps() {
  LightImage image(4, 1);
  for (int column = 0; column < 4; ++column)
    image.at(column, 0) = {static_cast<float>(column) / 4, 0, 0};
  return image;
}

}  // namespace

TEST_CASE("a texel's center is half a texel from its edge") {
  const FilteredTexture texture{.pyramid = pyramid_of(steps()), .filter = Filter::bilinear};
  const auto red = [&](double u) { return texture(Uv<double>{u, 0.5}).r; };
  expect_number(
      "red at the center of column 1, u = 1.5 / 4", red(1.5 / 4), 0.25,
      {{0.375, "centers are at whole numbers here: half a texel off"}, {0.5, "one texel off"}});
  expect_number("red between columns 1 and 2, u = 2 / 4", red(0.5), 0.375,
                {{0.5, "the nearest texel alone: nothing was mixed"},
                 {0.25, "the nearest texel alone: nothing was mixed"}});
}

TEST_CASE("the footprint is as long as the derivative says, in texels") {
  const Uv<Dual<double>> uv{{0.5, 3.0 / 64, 0}, {0.5, 0, 2.0 / 32}};
  const Footprint<double> footprint = footprint_of(uv, 64.0, 32.0);
  expect_number("the longer side for derivatives of 3 and 2 texels", footprint.longer, 3,
                {{6, "twice as wide as the pixel"},
                 {1.5, "half as wide as the pixel"},
                 {3.0 / 64, "in (u, v) and not in texels: multiply by the width"}});
  expect_number("the shorter side", footprint.shorter, 2,
                {{3, "as wide as long: everything is blurred"}});
}

TEST_CASE("a level is twice as coarse as the one before") {
  expect_number("the level for texels of width 4", level_place(4.0, 5).number, 2,
                {{3, "one level too high: everything is blurred"},
                 {1, "one level too low: far away it flickers"},
                 {4, "the logarithm is missing"}});
  const Pyramid pyramid = pyramid_of(steps());
  expect_number("the levels of a picture of 4 x 1 texels", pyramid.last_level() + 1, 3, {},
                "the pyramid ends at one texel");
  expect_number("red of the last level", pyramid.smaller.pixels.back().r, 0.375,
                {{0, "the first texel was taken, and not the mean"},
                 {0.75, "the sum was not divided"},
                 {1.5, "the sum was not divided"}});
}
