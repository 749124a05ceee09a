// The diagrams of chapter 11 show what its formulas say.
#include <doctest.h>

#include <cmath>
#include <string>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

namespace {

double dot_product(Spot a, Spot b) { return a.x * b.x + a.y * b.y; }

}  // namespace

TEST_CASE("the raised normal is at a right angle to the raised surface, and leans downhill") {
  const Drawing d = named("raised_normal");
  const Spot along = d.marked("along") - d.marked("foot");
  const Spot raised = d.marked("raised") - d.marked("foot");
  CHECK(dot_product(along, raised) == doctest::Approx(0));
  CHECK(along.y < 0);   // uphill to the right
  CHECK(raised.x < 0);  // and it leans to the left
  // On the hill: away from its top.
  const Spot lean = d.marked("leaning") - d.marked("normal");
  CHECK(dot_product(lean, d.marked("hill top") - d.marked("point")) < 0);
}
