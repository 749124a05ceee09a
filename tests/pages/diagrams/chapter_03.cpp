// The diagrams of chapter 03 show what its formulas say.
#include <doctest.h>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

TEST_CASE("the point is inside the texel that is marked") {
  const Drawing d = named("texel_grid");
  const Spot inside = d.marked("point") - d.marked("texel");
  CHECK(inside.x == doctest::Approx(0.2 * 52));  // 0.4 * 8 = 3.2
  CHECK(inside.y == doctest::Approx(0.8 * 52));  // (1 - 0.8) * 4 = 0.8
}
