// The diagrams of chapter 14 show what its formulas say.
#include <doctest.h>

#include <string>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

TEST_CASE("the step between numbers doubles at each power of two") {
  const Drawing d = named("floats_on_a_line");
  double before = 0;
  for (int power = 0; power < 3; ++power) {
    const Spot first = d.marked(std::to_string(power) + " 0");
    const double step = distance(first, d.marked(std::to_string(power) + " 1"));
    CHECK(distance(first, d.marked(std::to_string(power) + " 3")) == doctest::Approx(3 * step));
    if (power > 0) CHECK(step == doctest::Approx(2 * before));
    before = step;
  }
}

TEST_CASE("h is 0.8 of r, a c is a float, and b squared lies between two") {
  const Drawing d = named("far_sphere");
  const Spot center = d.marked("center");
  CHECK(distance(center, d.marked("h")) == doctest::Approx(0.8 * distance(center, d.marked("r"))));
  CHECK(distance(d.marked("a c"), d.marked("float 0")) < 0.01);
  CHECK(d.marked("float 5").x < d.marked("b b").x);
  CHECK(d.marked("b b").x < d.marked("float 6").x);
  // The float nearest to b^2, which the diagram's line has at its sixth step.
  CHECK(static_cast<float>(1e6 - 0.64) == 999999.0F + 6.0F / 16);
}

TEST_CASE("near the pole steps of y go far on the circle, and steps of x go about as far as x") {
  const Drawing d = named("pole_steps");
  const auto step_of = [&d](const std::string& side, int k) {
    return distance(d.marked(side + " " + std::to_string(k)),
                    d.marked(side + " " + std::to_string(k + 1)));
  };
  CHECK(distance(d.marked("y 0"), d.marked("x 0")) ==
        doctest::Approx(distance(d.marked("left"), d.marked("right"))));
  CHECK(step_of("y", 0) > 2 * step_of("y", 1));
  for (int k = 0; k < 6; ++k) {
    CHECK(step_of("y", k) > 1.3 * step_of("x", k));
    CHECK(step_of("x", k) == doctest::Approx(150 * 0.05).epsilon(0.05));
    CHECK(distance(d.marked("left"), d.marked("y " + std::to_string(k))) == doctest::Approx(150));
  }
}

TEST_CASE("the rounded start is below the surface, and the lifted one above") {
  const Drawing d = named("shadow_start");
  CHECK(d.marked("rounded").y > d.marked("surface 1").y + 5);
  CHECK(d.marked("lifted").y < d.marked("surface 2").y - 5);
  CHECK(distance(d.marked("rounded"), d.marked("hit 1")) < 40 / std::sqrt(2.0));
}
