// The diagrams of chapter 03 show what its formulas say.
#include <doctest.h>

#include <array>
#include <cmath>
#include <string>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

TEST_CASE("the point is inside the texel that is marked") {
  const Drawing d = named("texel_grid");
  const Spot inside = d.marked("point") - d.marked("texel");
  CHECK(inside.x == doctest::Approx(0.2 * 52));  // 0.4 * 8 = 3.2
  CHECK(inside.y == doctest::Approx(0.8 * 52));  // (1 - 0.8) * 4 = 0.8
}

TEST_CASE("the ray of pixel (409, 283) reads the texel that the textbook's formulas name") {
  // The eye (0, 2, 8) looks at the origin; the angle of view is 60 degrees over 600 rows.
  const double pixel = 2 * std::tan(std::acos(-1.0) / 6) / 600, far = std::sqrt(68.0);
  const double x = (409 + 0.5 - 400) * pixel, y = (300 - 283 - 0.5) * pixel;
  const double dx = x, dy = (-2 + 8 * y) / far, dz = (-8 - 2 * y) / far;
  const double a = dx * dx + dy * dy + dz * dz, b = 2 * (2 * dy + 8 * dz), c = 68 - 1;
  const double t = (-b - std::sqrt(b * b - 4 * a * c)) / (2 * a);
  const double px = t * dx, py = 2 + t * dy, pz = 8 + t * dz, pi = std::acos(-1.0);
  const double column = 2048 * ((std::atan2(-pz, px) + pi) / (2 * pi));
  const double row = 1024 * (1 - std::acos(-py) / pi);

  const Drawing d = named("frayed_coast");
  const double size = d.marked("texel size").x;
  const Spot drawn = (d.marked("ray") - d.marked("corner")) * (1 / size) + d.marked("low");
  CHECK(drawn.x == doctest::Approx(column));
  CHECK(drawn.y == doctest::Approx(row));
}

TEST_CASE("the pixel around this ray covers some 25 texels") {
  const Drawing d = named("frayed_coast");
  const double size = d.marked("texel size").x;
  const std::array<Spot, 4> corners{d.marked("a"), d.marked("b"), d.marked("c"), d.marked("d")};
  double twice = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Spot p = corners[i], q = corners[(i + 1) % 4];
    twice += p.x * q.y - q.x * p.y;
    // The ray is inside: it is on the same side of all four edges.
    const Spot edge = q - p, to_ray = d.marked("ray") - p;
    CHECK(edge.x * to_ray.y - edge.y * to_ray.x > 0);
  }
  CHECK(twice / 2 / (size * size) == doctest::Approx(25).epsilon(0.1));
}

TEST_CASE("columns are half a texel off at both ends, in opposite directions, and right between") {
  const Drawing d = named("half_a_texel");
  const auto off = [&](int i) {
    const std::string number = std::to_string(i);
    return (d.marked("middle " + number).x - d.marked("painted " + number).x) / 60;
  };
  CHECK(off(0) == doctest::Approx(0.5));
  CHECK(off(7) == doctest::Approx(-0.5));
  CHECK(off(3) == doctest::Approx(-off(4)));
  CHECK(off(3) == doctest::Approx(0.5 - 3.0 / 7));
}
