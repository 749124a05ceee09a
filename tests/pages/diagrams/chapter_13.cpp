// The diagrams of chapter 13 show what its formulas say.
#include <doctest.h>

#include <string>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

TEST_CASE("at t = 1 the fit is an eighth of a turn, and the series is above or below it") {
  const Drawing d = named("arc_tangent_series");
  const double turn = -d.marked("unit").y;
  const double pi = 3.14159265358979;
  CHECK(distance(d.marked("exact"), d.marked("fit")) < 0.2);
  CHECK(d.marked("series 3").y - d.marked("exact").y ==
        doctest::Approx((pi / 4 - 2.0 / 3) / (2 * pi) * turn));
  CHECK(d.marked("exact").y - d.marked("series 5").y ==
        doctest::Approx((13.0 / 15 - pi / 4) / (2 * pi) * turn));
}

TEST_CASE("the error of degree 5 reaches its bounds four times, with alternating signs") {
  const Drawing d = named("arc_tangent_error");
  REQUIRE(d.marked("peaks").x == 4);  // three coefficients and one more: Chebyshev's theorem
  for (int k = 1; k <= 4; ++k) {
    const Spot bound = d.marked(k % 2 == 1 ? "lower" : "upper");
    CHECK(std::abs(d.marked("peak " + std::to_string(k)).y - bound.y) < 1);
  }
}

TEST_CASE("at degree 17 the series is about nine texels off, and the fit 2e-6") {
  const Drawing d = named("arc_tangent_degrees");
  const double decade = 17;
  // 1 - 1/3 + 1/5 - ... + 1/17 = 0.8131 instead of 0.7854.
  const double orders = std::log10((0.813091 - 0.785398) / (2 * 3.14159265) / 9.2e-10);
  CHECK((d.marked("fit 17").y - d.marked("series 17").y) / decade ==
        doctest::Approx(orders).epsilon(0.01));
  CHECK(d.marked("fit 17").x == d.marked("series 17").x);
}
