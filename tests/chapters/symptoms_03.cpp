// Chapter 03's symptoms: from (u, v) to a texel and its color, with the word for a mistake.

#include "scene/sphere.hpp"
#include "support/symptoms.hpp"
#include "texture/image_texture.hpp"
#include "texture/mapped.hpp"
#include "texture/uv.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

/// The place of (u, v) on a map of 4 columns and 4 rows.
TexelPlace<double> place_of(double u, double v) {
  return texel_place(Uv<double>{u, v}, 4, 4, VAxis::up, TexelRounding::floor);
}

}  // namespace

TEST_CASE("u runs to the right: columns are counted from the left") {
  expect_number("of 4 columns, the one at u = 0.1", place_of(0.1, 0.1).column, 0,
                {{3, "u runs the other way (mirrored)"}});
}

TEST_CASE("v runs up: row 0 of a file is its upper edge") {
  expect_number("of 4 rows, the one at v = 0.1", place_of(0.1, 0.1).row, 3,
                {{0, "v runs the other way (flipped): count rows from the other end"},
                 {4, "rows were counted from 1"}});
}

TEST_CASE("each of n columns is 1/n wide") {
  expect_number("of 4 columns, the one at u = 0.9", place_of(0.9, 0.5).column, 3,
                {{2, "(n - 1) u in place of n u: the last column is met at u = 1 alone"},
                 {4, "n u was rounded and not cut off (half a texel)"}});
  expect_number("of 4 columns, the one at u = 0.2", place_of(0.2, 0.5).column, 0,
                {{1, "n u was rounded and not cut off (half a texel)"}});
}

TEST_CASE("no coordinate leads out of the image") {
  const char* word = "this is outside the image: limit it (no clamp)";
  expect_number("of 4 columns, the one at u = 1", place_of(1, 0.5).column, 3, {{4, word}});
  expect_number("of 4 columns, the one at u = -0.5", place_of(-0.5, 0.5).column, 0, {{-2, word}},
                word);
}

TEST_CASE("a color is red, green, blue, and 255 is 1") {
  const Rgb color = ImageTexture{Image(1, 1, {204, 102, 51})}(Uv<double>{0.5, 0.5});
  expect_number("red of the texel (204, 102, 51)", color.r, 0.8,
                {{0.2, "red and blue are exchanged (BGR)"},
                 {204, "bytes are not divided by 255"},
                 {204 / 256.0, "255 must become 1: divide by 255, not 256"}});
}

TEST_CASE("the map's upper left corner is north, just east of the line at -x") {
  Image map(8, 4);
  map.at(0, 0) = {255, 255, 255};
  const Mapped<RtiowMapping, ImageTexture> paint{{}, {map}};
  const auto seen = [&](const Vec3d& direction) {
    Hit<double> hit;
    hit.normal = normalize(direction);
    return paint(hit).g;
  };
  expect_number("the corner's texel at (-1, 2, 0.1)", seen({-1, 2, 0.1}), 1, {},
                seen({-1, 2, -0.1}) > 0    ? "u runs the other way (mirrored)"
                : seen({-1, -2, 0.1}) > 0  ? "v runs the other way (flipped)"
                : seen({-1, -2, -0.1}) > 0 ? "both u and v run the other way"
                                           : "the map begins at another place");
}
