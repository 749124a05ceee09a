// Chapter 02's symptoms: (u, v) of a direction and the checkerboard, with the word for a mistake.
#include <limits>
#include <numbers>

#include "support/symptoms.hpp"
#include "texture/checkerboard.hpp"
#include "texture/uv.hpp"

using namespace texmap;
using namespace texmap::test;

TEST_CASE("u grows from -x through +z, +x and -z") {
  const struct {
    const char* name;
    Vec3d direction;
    double u;
  } places[] = {{"+x", {1, 0, 0}, 0.5},
                {"+z", {0, 0, 1}, 0.25},
                {"-z", {0, 0, -1}, 0.75},
                {"-x", {-1, 0, 0}, 0}};
  for (const auto& [name, direction, u] : places) {
    expect_number(std::string("u at ") + name, uv_rtiow(direction).u, u,
                  {{1 - u, "u runs the other way (mirrored)"},
                   {u - 0.5, "u begins at -1/2: the 1/2 is missing"},
                   {u == 0 ? 1.0 : -1.0, "u must stay below 1"}},
                  "u begins at another place, or is not divided by 2 pi");
  }
}

TEST_CASE("v grows from the south pole to the north pole, by the angle") {
  const double degrees = std::numbers::pi / 180;
  const Vec3d north{0, std::sin(30 * degrees), std::cos(30 * degrees)};
  expect_number("v at 30 degrees north", uv_rtiow(north).v, 2 / 3.0,
                {{0.75, "v was taken from the height, without the angle"},
                 {1 / 3.0, "v runs the other way (flipped)"}});
}

TEST_CASE("at the poles and next to them v is exact") {
  const double above_one = 1 + std::numeric_limits<double>::epsilon();
  expect_number("v of a normal of length 1 + 2^-52 at the north pole",
                uv_rtiow(Vec3d{0, above_one, 0}).v, 1,
                {{0, "acos of a number above 1 is not a number (acos at the pole)"},
                 {std::nan(""), "acos of a number above 1 is not a number (acos at the pole)"}});
  const double from_pole = 1 - uv_rtiow(Vec3d{1e-9, 1, 0}).v;
  expect_number("1 - v at 1e-9 from the north pole, in units of 1e-9 / pi",
                from_pole * std::numbers::pi * 1e9, 1,
                {{0, "acos loses the digits of small angles (acos at the pole)"}}, "", 1e-6);
  expect_number("u at the pole, where every u is right", uv_rtiow(Vec3d{0, 1, 0}).u, 0.5, {},
                "the course takes 1/2 there");
}

TEST_CASE("only the direction counts, not the length") {
  const Vec3d p{1, 2, 3};
  expect_number("v of a direction three times as long", uv_rtiow(p * 3.0).v, uv_rtiow(p).v, {},
                "divide by the length first");
}

TEST_CASE("the checkerboard's squares begin at (0, 0) and alternate both ways") {
  const Checkerboard board{.even = {1, 0, 0}, .odd = {0, 0, 1}, .squares = 10};
  const auto red = [&](double u, double v) { return board(Uv<double>{u, v}).r; };
  expect_number("red at (0.05, 0.05)", red(0.05, 0.05), 1,
                {{0, "the two colors are exchanged, or squares begin half a square away"}});
  expect_number("red at (0.15, 0.05)", red(0.15, 0.05), 0, {{1, "u does not change the square"}});
  expect_number("red at (0.05, 0.15)", red(0.05, 0.15), 0, {{1, "v does not change the square"}});
  expect_number("red at (0.15, 0.15)", red(0.15, 0.15), 1, {{0, "add column and row"}});
  expect_number("red at (0.95, 1)", red(0.95, 1), 1,
                {{0, "v = 1 belongs to the last row: there is no row 10"}});
}
