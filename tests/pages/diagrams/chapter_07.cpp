// The diagrams of chapter 07 show what its formulas say.
#include <doctest.h>

#include <set>
#include <string>
#include <utility>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

namespace {

/// How many cells of a grid have a dot of this pattern.
std::size_t cells_with_a_dot(const Drawing& d, const std::string& pattern, int columns, int rows) {
  std::set<std::pair<int, int>> cells;
  for (int i = 0; i < 16; ++i) {
    const Spot at = d.marked(pattern + " " + std::to_string(i));
    cells.insert({static_cast<int>(at.x * columns), static_cast<int>(at.y * rows)});
  }
  return cells.size();
}

}  // namespace

TEST_CASE("the dots keep the rules that are written below them") {
  const Drawing d = named("sampler_patterns");
  CHECK(cells_with_a_dot(d, "random", 4, 4) < 14);
  CHECK(cells_with_a_dot(d, "stratified", 4, 4) == 16);
  CHECK(cells_with_a_dot(d, "multi-jitter", 4, 4) == 16);
  CHECK(cells_with_a_dot(d, "multi-jitter", 16, 1) == 16);
  CHECK(cells_with_a_dot(d, "multi-jitter", 1, 16) == 16);
  for (const int columns : {1, 2, 4, 8, 16})
    CHECK(cells_with_a_dot(d, "sobol", columns, 16 / columns) == 16);
  CHECK(cells_with_a_dot(d, "multi-jitter", 8, 2) < 16);
  CHECK(cells_with_a_dot(d, "stratified", 16, 1) < 16);
}

TEST_CASE("on the left the tips lie on a circle through the foot, on the right above equal steps") {
  const Drawing d = named("cosine_and_chance");
  for (int i = 0; i < 13; ++i) {
    const Spot weighted = d.marked("weighted " + std::to_string(i));
    CHECK(distance(weighted, {0, -75}) == doctest::Approx(75));
    const Spot chosen = d.marked("chosen " + std::to_string(i));
    CHECK(distance(chosen, {0, 0}) == doctest::Approx(150));
    CHECK(chosen.x == doctest::Approx(300.0 / 13 * (i - 6)));
  }
}

TEST_CASE("byte 128 has 0.216 of the light, and half of the light belongs to byte 188") {
  const Drawing d = named("srgb_curve");
  const Spot origin = d.marked("origin");
  const Spot full = d.marked("white") - origin;
  const Spot dark = d.marked("128") - origin;
  const Spot half = d.marked("half") - origin;
  CHECK(dark.y / full.y == doctest::Approx(0.216).epsilon(0.001));
  CHECK(half.y / full.y == doctest::Approx(0.5));
  CHECK(255 * half.x / full.x == doctest::Approx(187.516));
}
