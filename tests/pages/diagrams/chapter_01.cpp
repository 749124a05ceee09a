// The diagrams of chapter 01 show what its formulas say.
#include <doctest.h>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

TEST_CASE("the eye, the pixel's center and the hit lie on one line, in this order") {
  const Drawing d = named("eye_and_pixels");
  const Spot eye = d.marked("eye"), pixel = d.marked("pixel"), hit = d.marked("hit");
  CHECK(distance(eye, pixel) + distance(pixel, hit) == doctest::Approx(distance(eye, hit)));
}

TEST_CASE("the two roots are as far from the sphere's center as its edge") {
  const Drawing d = named("line_and_sphere");
  CHECK(distance(d.marked("near"), d.marked("center")) == doctest::Approx(62));
  CHECK(distance(d.marked("far"), d.marked("center")) == doctest::Approx(62));
  CHECK(d.marked("near").x < d.marked("far").x);
}

TEST_CASE("at 60 degrees the same beam lights twice the width") {
  const Drawing d = named("lambert");
  const double straight = distance(d.marked("straight left"), d.marked("straight right"));
  CHECK(distance(d.marked("slanted left"), d.marked("slanted right")) ==
        doctest::Approx(2 * straight));
}

TEST_CASE("from the picture's middle the pixel's center is half the arrow to the right, 0.3 up") {
  const Drawing d = named("camera_axes");
  const Spot expected = d.marked("middle") + d.marked("right") * 0.5 + d.marked("up") * 0.3;
  CHECK(distance(d.marked("pixel"), expected) < 1e-9);
}
