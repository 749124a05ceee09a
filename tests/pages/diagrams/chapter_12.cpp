// The diagrams of chapter 12 show what its formulas say.
#include <doctest.h>

#include <array>
#include <cmath>
#include <string>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

TEST_CASE("the mirrored direction is the eye's, flipped about the normal, and leads to the texel") {
  const Drawing d = named("mirrored_ray");
  const Spot foot = d.marked("foot"), e = d.marked("e") - foot, r = d.marked("r") - foot;
  const Spot n = d.marked("n") - foot, seen = d.marked("seen") - foot;
  CHECK(n.x == doctest::Approx(0));
  CHECK(r.x == doctest::Approx(-e.x));
  CHECK(r.y == doctest::Approx(e.y));
  CHECK(std::hypot(r.x, r.y) == doctest::Approx(std::hypot(n.x, n.y)));
  CHECK(r.x * seen.y - r.y * seen.x == doctest::Approx(0));
}

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

TEST_CASE("the pieces of each texel in all boxes add up to four times its probability") {
  const Drawing d = named("alias_table");
  std::array<double, 4> sums{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Spot box = d.marked("share " + std::to_string(i));
    sums[i] += box.x;
    sums[static_cast<std::size_t>(box.y)] += 1 - box.x;
  }
  const std::array<double, 4> probabilities{0.10, 0.15, 0.575, 0.175};
  for (std::size_t i = 0; i < 4; ++i) CHECK(sums[i] == doctest::Approx(4 * probabilities[i]));
}
