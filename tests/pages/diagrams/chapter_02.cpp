// The diagrams of chapter 02 show what its formulas say.
#include <doctest.h>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

TEST_CASE("the view is right-handed: x to the right, z towards the reader, the seam at -x") {
  const Drawing d = named("sphere_uv");
  const Spot center = (d.marked("north") + d.marked("south")) * 0.5;
  CHECK(d.marked("north").y < d.marked("south").y);
  CHECK(d.marked("+x").x > center.x);
  CHECK(d.marked("+z").y > center.y);
  const Spot opposite = center * 2 - d.marked("+x");
  CHECK(distance(d.marked("seam on the equator"), opposite) < 1e-9);
}

TEST_CASE(
    "from a cosine the first angle after the pole is more than five times as far as from a sine") {
  const Drawing d = named("flat_cosine");
  const double gap = distance(d.marked("first angle from the cosine"), d.marked("pole"));
  const double sine = distance(d.marked("first angle from the sine"), d.marked("pole of the sine"));
  // cos 20.364 degrees is 15/16, and sin 3.583 degrees is 1/16.
  CHECK(gap / sine == doctest::Approx(20.36413 / 3.583322));
}
