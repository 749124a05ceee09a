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

TEST_CASE("the axis points stand on the equator at u = 0, 1/4, 1/2 and 3/4") {
  const Drawing d = named("unfolding");
  const double u0 = d.marked("-x").x;
  const double quarter = d.marked("+z").x - u0;
  CHECK(quarter == doctest::Approx(120));
  CHECK(d.marked("+x").x - u0 == doctest::Approx(2 * quarter));
  CHECK(d.marked("-z").x - u0 == doctest::Approx(3 * quarter));
  for (const char* name : {"-x", "+z", "+x", "-z"}) CHECK(d.marked(name).y == doctest::Approx(160));
}
