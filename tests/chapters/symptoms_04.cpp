// Chapter 04's symptoms: three conventions for (u, v), with the word for a mistake.
#include "support/symptoms.hpp"
#include "texture/conventions.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

const Vec3d east{1, 0, 0};
const Vec3d front{0, 0, 1};
const Vec3d north{0, 1, 0};

}  // namespace

TEST_CASE("each convention begins u at its place and runs its way") {
  expect_number("u at +z in the book's convention", uv_of(Convention::rtiow, front).u, 0.25,
                {{0.75, "u runs the other way (mirrored)"}, {0, "this is the lecture's u"}});
  expect_number("u at +z in the daily exercise's convention", uv_of(Convention::daily, front).u,
                0.75, {{0.25, "this is the book's u: the daily exercise's runs west (mirrored)"}});
  expect_number("u at +z in the lecture's convention", uv_of(Convention::lecture, front).u, 0,
                {{0.25, "this is the book's u: the lecture's begins at +z (a quarter turn)"},
                 {0.5, "the quarter was added and not taken away"}});
  expect_number("u at +x in the lecture's convention", uv_of(Convention::lecture, east).u, 0.25,
                {{0.5, "this is the book's u: the lecture's begins at +z (a quarter turn)"},
                 {0.75, "u runs the other way (mirrored)"}});
}

TEST_CASE("v is 1 at the north pole, but 0 in the daily exercise") {
  for (const Convention up : {Convention::rtiow, Convention::lecture})
    expect_number("v at the north pole", uv_of(up, north).v, 1,
                  {{0, "v runs the other way (flipped)"}});
  expect_number("v at the north pole in the daily exercise", uv_of(Convention::daily, north).v, 0,
                {{1, "the daily exercise's v runs down (flipped)"}});
  expect_that(
      v_axis_of(Convention::daily) == VAxis::down && v_axis_of(Convention::rtiow) == VAxis::up,
      "the daily exercise's row 0 is at v = 0, the others' at v = 1", "the image is flipped");
}

TEST_CASE("the lecture multiplies by n - 1") {
  expect_number("of 4 columns, the lecture's at u = 0.9",
                texel_number(0.9, 4, TexelRounding::lecture), 2,
                {{3, "n u in place of (n - 1) u"}});
}
