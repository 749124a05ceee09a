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

TEST_CASE("the axis points are on the equator at u = 0, 1/4, 1/2 and 3/4") {
  const Drawing d = named("unfolding");
  const double u0 = d.marked("-x").x;
  const double quarter = d.marked("+z").x - u0;
  CHECK(quarter == doctest::Approx(120));
  CHECK(d.marked("+x").x - u0 == doctest::Approx(2 * quarter));
  CHECK(d.marked("-z").x - u0 == doctest::Approx(3 * quarter));
  for (const char* name : {"-x", "+z", "+x", "-z"}) CHECK(d.marked(name).y == doctest::Approx(160));
}

TEST_CASE("seen from above, +z is below +x, and p is where its longitude says") {
  const Drawing d = named("longitude");
  const Spot center = d.marked("center"), x = d.marked("+x: φ = 0"), z = d.marked("+z: φ = π/2");
  const double radius = distance(x, center);
  CHECK(x.y == doctest::Approx(center.y));
  CHECK(x.x > center.x);
  CHECK(z.x == doctest::Approx(center.x));
  CHECK(z.y == doctest::Approx(center.y + radius));
  // u = 0.38 is 0.12 of a turn from +x toward +z: 43.2 degrees.
  CHECK(d.marked("p").x - center.x == doctest::Approx(radius * 0.7289686));
  CHECK(d.marked("p").y - center.y == doctest::Approx(radius * 0.6845471));
}

TEST_CASE("seen from the side, p is at 0.66 of the half turn from the south pole") {
  const Drawing d = named("polar_angle");
  const Spot center = d.marked("center"), south = d.marked("south pole");
  const double radius = distance(south, center);
  CHECK(south.y == doctest::Approx(center.y + radius));
  CHECK(d.marked("north pole").y == doctest::Approx(center.y - radius));
  // 118.8 degrees.
  CHECK(d.marked("p").x - center.x == doctest::Approx(radius * 0.8763067));
  CHECK(center.y - d.marked("p").y == doctest::Approx(radius * 0.4817537));
}

TEST_CASE(
    "from a cosine the first angle after the pole is more than five times as far as from a sine") {
  const Drawing d = named("flat_cosine");
  const double gap = distance(d.marked("first angle from the cosine"), d.marked("pole"));
  const double sine = distance(d.marked("first angle from the sine"), d.marked("pole of the sine"));
  // cos 20.364 degrees is 15/16, and sin 3.583 degrees is 1/16.
  CHECK(gap / sine == doctest::Approx(20.36413 / 3.583322));
}

TEST_CASE("p is inside the square of column 3 and row 6") {
  const Drawing d = named("checkerboard");
  const Spot inside = d.marked("p") - d.marked("square");
  CHECK(inside.x == doctest::Approx(0.8 * 48));
  CHECK(inside.y == doctest::Approx(0.4 * 24));  // rows go up: 0.6 above the lower edge
  const Spot origin = d.marked("u = v = 0"), end = d.marked("u = v = 1");
  CHECK(d.marked("p").x == doctest::Approx(origin.x + 0.38 * (end.x - origin.x)));
  CHECK(d.marked("p").y == doctest::Approx(origin.y + 0.66 * (end.y - origin.y)));
}
