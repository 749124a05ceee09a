// The diagrams of chapter 06 show what its formulas say.
#include <doctest.h>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

TEST_CASE("the powers fall to one half where their roots say") {
  const Drawing d = named("phong_power");
  const double zero = d.marked("0 degrees").x;
  const double degree = (d.marked("90 degrees").x - zero) / 90;
  const auto half = [&](const char* name) { return (d.marked(name).x - zero) / degree; };
  CHECK(half("half at 1") == doctest::Approx(60));
  CHECK(half("half at 5") == doctest::Approx(29.48).epsilon(0.001));
  CHECK(half("half at 50") == doctest::Approx(9.52).epsilon(0.001));
  CHECK(half("half at 500") == doctest::Approx(3.02).epsilon(0.002));
}
