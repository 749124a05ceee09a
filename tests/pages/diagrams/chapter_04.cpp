// The diagrams of chapter 04 show what its formulas say.
#include <doctest.h>

#include <cmath>
#include <string>

#include "pages/diagrams/named.hpp"
#include "published/uv.hpp"
#include "texture/texel.hpp"

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

/// The direction of a place around a circle seen from above: x to the right, z down.
Vec3d direction_from_above(const Drawing& d, const std::string& mark) {
  const Spot from_center = between(d, "center", mark);
  return normalize(Vec3d{from_center.x, 0, from_center.y});
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

TEST_CASE("the four letters show the four pairs of signs") {
  const Drawing d = named("letter_and_faults");
  const auto check = [&](const std::string& letter, bool arm_is_east, bool corner_is_north) {
    CAPTURE(letter);
    CHECK((between(d, letter + " corner", letter + " arm").x > 10) == arm_is_east);
    CHECK((between(d, letter + " foot", letter + " corner").y < -10) == corner_is_north);
  };
  check("reads as printed", true, true);
  check("mirrored", false, true);
  check("upside down, mirrored", true, false);
  check("turned by half a turn", false, false);
}

TEST_CASE("from above, each arrow begins where the document's own formula has 0, and u grows") {
  const Drawing d = named("u_from_above");
  const auto check = [&](const std::string& document, auto formula) {
    CAPTURE(document);
    const double begins = formula(direction_from_above(d, document + " begins")).u;
    const double later = formula(direction_from_above(d, document + " a little later")).u;
    CHECK(std::abs(begins - std::round(begins)) < 1e-9);  // 0 and 1 are one meridian
    CHECK(later == doctest::Approx(0.05));
  };
  check(daily, published::uv_daily<double>);
  check(next_week, published::uv_one_weekend_2020<double>);
  check(next_week, published::uv_next_week_v4<double>);
  check(lecture, published::uv_lecture<double>);
}

TEST_CASE("every cell of the two bars holds the u of its column") {
  const Drawing d = named("texel_rounding");
  const double left = d.marked("floor 0").x, width = d.marked("end").x - left;
  const auto check = [&](const std::string& bar, int column, TexelRounding rounding) {
    CAPTURE(bar);
    CAPTURE(column);
    const double u = (d.marked(bar + std::to_string(column)).x - left) / width;
    CHECK(texel_number(u + 0.001, 8, rounding) == column);
    if (column > 0) CHECK(texel_number(u - 0.001, 8, rounding) == column - 1);
  };
  for (int column = 0; column < 8; ++column) check("floor ", column, TexelRounding::floor);
  for (int column = 0; column < 7; ++column) check("lecture ", column, TexelRounding::lecture);
  CHECK(texel_number(0.9999, 8, TexelRounding::lecture) == 6);
  CHECK(texel_number(1.0, 8, TexelRounding::lecture) == 7);
}
