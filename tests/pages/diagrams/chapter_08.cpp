// The diagrams of chapter 08 show what its formulas say.
#include <doctest.h>

#include <cmath>
#include <string>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

TEST_CASE("the small triangles have the shares of the area that are the weights") {
  const Drawing d = named("barycentric");
  const Spot a = d.marked("a"), b = d.marked("b"), c = d.marked("c"), p = d.marked("p");
  // Heron's formula: another way to the same areas.
  const auto area = [](Spot x, Spot y, Spot z) {
    const double i = distance(x, y), k = distance(y, z), m = distance(z, x), s = (i + k + m) / 2;
    return std::sqrt(s * (s - i) * (s - k) * (s - m));
  };
  CHECK(area(p, b, c) / area(a, b, c) == doctest::Approx(0.4));
  CHECK(area(p, c, a) / area(a, b, c) == doctest::Approx(0.2));
  CHECK(area(p, a, b) / area(a, b, c) == doctest::Approx(0.4));
}

TEST_CASE("in the texture the point is at (0.6, 0.4)") {
  const Drawing d = named("barycentric");
  const Spot origin = d.marked("origin of the texture");
  const double size = d.marked("b in the texture").x - origin.x;
  const Spot p = d.marked("p in the texture") - origin;
  CHECK(p.x / size == doctest::Approx(0.6));
  CHECK(-p.y / size == doctest::Approx(0.4));
}

TEST_CASE("the ray is close to the shared edge and below it") {
  const Drawing d = named("shared_edge");
  const Spot a = d.marked("a"), ray = d.marked("ray") - a;
  const Spot edge = d.marked("c") - a;
  const double slope = edge.y / edge.x;
  CHECK(ray.y > slope * ray.x);  // y goes down
  CHECK(std::abs(ray.y - slope * ray.x) / std::hypot(1, slope) < 10);
}

TEST_CASE("the wrap modes show the texels that their definitions name") {
  const Drawing d = named("wrap_modes");
  const std::string repeat = "012301230123", mirror = "321001233210", clamp = "000001233333";
  for (int i = -4; i < 8; ++i) {
    const auto at = static_cast<std::size_t>(i + 4);
    const std::string place = " " + std::to_string(i) + " shows ";
    CHECK(d.marked("repeat" + place + repeat[at]).x == doctest::Approx(86 + 43 * (i + 4)));
    CHECK_NOTHROW(static_cast<void>(d.marked("mirror" + place + mirror[at])));
    CHECK_NOTHROW(static_cast<void>(d.marked("clamp" + place + clamp[at])));
  }
}
