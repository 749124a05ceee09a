// The diagrams of chapter 04 show what its formulas say.
#include <doctest.h>

#include <cmath>
#include <string>

#include "pages/diagrams/named.hpp"
#include "published/uv.hpp"

using namespace texmap;
using namespace texmap::diagrams;

namespace {

const std::string daily = "daily exercise";
const std::string next_week = "One Weekend 2020, Next Week";
const std::string lecture = "lecture";

/// A vector between two marked places.
Spot between(const Drawing& d, const std::string& from, const std::string& to) {
  return d.marked(to) - d.marked(from);
}

}  // namespace

TEST_CASE("on the globes u and v run as each document says: the viewer looks between -x and +z") {
  const Drawing d = named("four_conventions");
  CHECK(between(d, daily + " start", daily + " u").x < -10);
  CHECK(between(d, next_week + " start", next_week + " u").x > 10);
  CHECK(between(d, lecture + " start", lecture + " u").x > 10);
  CHECK(between(d, daily + " start", daily + " v").y > 10);  // y grows down the drawing
  CHECK(between(d, next_week + " start", next_week + " v").y < -10);
  CHECK(between(d, lecture + " start", lecture + " v").y < -10);
}

TEST_CASE("u = 0 is drawn at -x in two conventions and at +z in the lecture's") {
  const Drawing d = named("four_conventions");
  // -x and +z are 45 degrees to the left and to the right of the viewer.
  const double aside = 72 * std::sqrt(0.5);
  CHECK(between(d, daily + " center", daily + " u = 0").x == doctest::Approx(-aside));
  CHECK(between(d, next_week + " center", next_week + " u = 0").x == doctest::Approx(-aside));
  CHECK(between(d, lecture + " center", lecture + " u = 0").x == doctest::Approx(aside));
}

TEST_CASE("the letter F is upright on every globe and is mirrored on the daily exercise's") {
  const Drawing d = named("four_conventions");
  for (const std::string& document : {daily, next_week, lecture})
    CHECK(between(d, document + " foot", document + " corner").y < -30);
  CHECK(between(d, daily + " corner", daily + " arm").x < -10);
  CHECK(between(d, next_week + " corner", next_week + " arm").x > 10);
  CHECK(between(d, lecture + " corner", lecture + " arm").x > 10);
}
