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

TEST_CASE("with green inverted the flank towards v leans the other way, as the far one did") {
  const Drawing d = named("green_up_or_down");
  const auto normal = [&](const std::string& name) {
    return d.marked(name + " tip") - d.marked(name);
  };
  CHECK(normal("up near").x < 0);  // v grows to the left
  CHECK(normal("down near").x == doctest::Approx(-normal("up near").x));
  CHECK(normal("down near").y == doctest::Approx(normal("up near").y));
  CHECK(normal("down near").x == doctest::Approx(normal("up far").x));
}

TEST_CASE("the facets have the lean that they are drawn with, and the line closes") {
  const Drawing d = named("two_facets");
  const Spot foot = d.marked("foot"), tip = d.marked("tip"), next = d.marked("next");
  CHECK(tip.x == doctest::Approx(next.x));  // upright
  CHECK(next.y == doctest::Approx(foot.y));
  const double lean = 35 * std::acos(-1.0) / 180;
  CHECK(distance(foot, tip) == doctest::Approx(distance(foot, next) / std::cos(lean)));
}
