// The diagrams of chapter 12 show what its formulas say.
#include <doctest.h>

#include <array>
#include <cmath>
#include <string>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

TEST_CASE("the solid angles are (2 pi / width) (cos a - cos b), and all texels have 4 pi") {
  const Drawing d = named("sky_texels");
  const double pi = std::acos(-1.0);
  const auto solid_angle = [pi](int row) {
    return 2 * pi / 16 * (std::cos(pi * row / 8) - std::cos(pi * (row + 1) / 8));
  };
  double all = 0;
  for (int row = 0; row < 8; ++row) all += 16 * solid_angle(row);
  CHECK(all == doctest::Approx(4 * pi));
  for (const int row : {0, 3}) {
    CHECK(d.marked("solid angle in row " + std::to_string(row)).x ==
          doctest::Approx(solid_angle(row)));
  }
  // The texel at the pole is above the one at the equator.
  CHECK(d.marked("texel in row 0").y < d.marked("texel in row 3").y);
}
