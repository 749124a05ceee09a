// The diagrams of chapter 14 show what its formulas say.
#include <doctest.h>

#include <string>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

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
