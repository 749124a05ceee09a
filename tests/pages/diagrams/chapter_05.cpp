// The diagrams of chapter 05 show what its formulas say.
#include <doctest.h>

#include <cmath>
#include <numbers>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

TEST_CASE("the two axes and the point turn by one angle, against the clock as seen from above") {
  const Drawing d = named("rotation_from_above");
  const double r = 110, beta = 35 * std::numbers::pi / 180;
  const Spot x = d.marked("x'") - d.marked("center");
  CHECK(x.x == doctest::Approx(r * std::cos(beta)));
  CHECK(x.y == doctest::Approx(-r * std::sin(beta)));
  const Spot z = d.marked("z'") - d.marked("center");
  CHECK(z.x == doctest::Approx(r * std::sin(beta)));
  CHECK(z.y == doctest::Approx(r * std::cos(beta)));
  const Spot p = d.marked("p") - d.marked("center"), turned = d.marked("p'") - d.marked("center");
  CHECK(p.x * turned.x + p.y * turned.y == doctest::Approx(r * r * std::cos(beta)));
  CHECK(p.x * turned.y - p.y * turned.x == doctest::Approx(-r * r * std::sin(beta)));
}

TEST_CASE(
    "the look-up goes east to where the continent was, and the continent comes to the point") {
  const Drawing d = named("look_up_and_picture");
  const Spot p = d.marked("p") - d.marked("center"),
             looked_up = d.marked("p'") - d.marked("center");
  CHECK(p.x == doctest::Approx(0));
  CHECK(p.y == doctest::Approx(92));  // towards the eye
  CHECK(looked_up.x == doctest::Approx(92 * std::sin(50 * std::numbers::pi / 180)));
  // The second globe is 270 to the right of the first.
  CHECK(distance(d.marked("continent before") + Spot{270, 0}, d.marked("p'")) < 1e-9);
  CHECK(distance(d.marked("continent after"), d.marked("p")) < 1e-9);
}
