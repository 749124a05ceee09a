// The diagrams of chapter 10 show what its formulas say.
#include <doctest.h>

#include <cmath>
#include <string>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

namespace {

/// Where a mark is in a layout's picture: 0 to 1 from the left and from the lower edge.
Spot share(const Drawing& d, const std::string& word, const std::string& mark) {
  const Spot top = d.marked(word + " top"), bottom = d.marked(word + " bottom");
  const Spot at = d.marked(word + mark);
  return {(at.x - top.x) / (bottom.x - top.x), (bottom.y - at.y) / (bottom.y - top.y)};
}

}  // namespace

TEST_CASE("latitude 30 is a third of the way to the pole, on the cylinder half of it") {
  const Drawing d = named("seven_layouts");
  CHECK(share(d, "equirect", " 30 N").y == doctest::Approx(0.5 + 0.5 / 3));
  CHECK(share(d, "cylinder", " 30 N").y == doctest::Approx(0.75));
  // On a face of a cube: tan 30 degrees of half its height, and 30 / 45 of it.
  CHECK(share(d, "cube", " 30 N").y ==
        doctest::Approx(0.75 + 0.25 * std::tan(std::acos(-1.0) / 6)));
  CHECK(share(d, "equi-angular", " 30 N").y == doctest::Approx(0.75 + 0.25 * 2 / 3));
}

TEST_CASE("the north pole is the middle of the plane and of both octahedral maps") {
  const Drawing d = named("seven_layouts");
  for (const char* word : {"plane", "octahedral", "equal-area"}) {
    CAPTURE(word);
    CHECK(share(d, word, " pole").x == doctest::Approx(0.5));
    CHECK(share(d, word, " pole").y == doctest::Approx(0.5));
  }
}

TEST_CASE("the folded point is the mirror image in the edge of the upper half") {
  const Drawing d = named("octahedron_unfolded");
  const Spot under = d.marked("under"), folded = d.marked("folded");
  for (const char* corner : {"right corner", "lower corner"}) {
    CHECK(distance(under, d.marked(corner)) == doctest::Approx(distance(folded, d.marked(corner))));
  }
  CHECK(distance(folded, d.marked("middle")) > distance(under, d.marked("middle")) + 10);
}

TEST_CASE("circles grow wider by 1 / cos of their latitude") {
  const Drawing d = named("pole_stretch");
  const auto width = [&](const std::string& latitude) {
    return distance(d.marked(latitude + " west"), d.marked(latitude + " east"));
  };
  // The width of a circle of 9 degrees: tan of its half in longitude is tan 9 degrees / cos.
  const double map = distance(d.marked("map left"), d.marked("map right"));
  const double degree = std::acos(-1.0) / 180;
  for (const int latitude : {0, 45, 70}) {
    CAPTURE(latitude);
    const double half = std::atan(std::tan(9 * degree) / std::cos(latitude * degree)) / degree;
    CHECK(width(std::to_string(latitude)) == doctest::Approx(map * 2 * half / 360));
  }
}
