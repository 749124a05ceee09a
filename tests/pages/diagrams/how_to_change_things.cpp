// The diagrams of docs/how_to_change_things.md show what the formulas say.
#include <doctest.h>

#include <cmath>
#include <string>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

TEST_CASE(
    "the example of the parts of a paint has Next Week's (u, v), and the color of its square") {
  const std::string svg = named("parts_of_a_paint").svg();
  const double pi = std::acos(-1.0);
  const double u = (std::atan2(-0.64, 0.48) + pi) / (2 * pi);
  const double v = std::acos(-0.6) / pi;
  CHECK(u == doctest::Approx(0.3524).epsilon(1e-3));
  CHECK(v == doctest::Approx(0.7048).epsilon(1e-3));
  CHECK(svg.find(">(0.35, 0.70)<") != std::string::npos);
  // Square 3 from the left and 7 from below: even, so blue.
  CHECK((static_cast<int>(10 * u) + static_cast<int>(10 * v)) % 2 == 0);
  CHECK(svg.find(">(0.2, 0.2, 0.8)<") != std::string::npos);
}
