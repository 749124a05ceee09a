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

TEST_CASE("along the ray a corner goes to its place on the plane z = 0") {
  const Drawing d = named("view_along_ray");
  // The page's formula, with the ray's direction (0.4, 0.25, 1).
  struct Corner {
    std::string name;
    double x, y, z;
  };
  for (const Corner& p : {Corner{"a", -0.48, -0.45, 1.8}, Corner{"b", 2.31, 0.225, 2.9},
                          Corner{"c", 0.88, 1.65, 2.2}}) {
    const Spot place{p.x - p.z * 0.4, p.y - p.z * 0.25};
    const Spot flat = d.marked(p.name + " seen flat") - d.marked("ray seen flat");
    CHECK(flat.x == doctest::Approx(85 * place.x));
    CHECK(flat.y == doctest::Approx(-85 * place.y));  // y goes down

    // In space a corner slides in the direction of the ray, z / 4.2 of the arrow's length.
    const Spot ray = d.marked("ray's end") - d.marked("ray's origin");
    const Spot slid = d.marked(p.name + " in space") - d.marked(p.name + " on the plane");
    CHECK(slid.x == doctest::Approx(ray.x * p.z / 4.2));
    CHECK(slid.y == doctest::Approx(ray.y * p.z / 4.2));
  }
}

TEST_CASE("the ray meets the triangle where the areas on the plane say") {
  const Drawing d = named("view_along_ray");
  const auto area = [](Spot a, Spot b) { return a.x * b.y - a.y * b.x; };
  const Spot origin = d.marked("ray seen flat");
  const Spot a = d.marked("a seen flat") - origin, b = d.marked("b seen flat") - origin,
             c = d.marked("c seen flat") - origin;
  const double whole = area(a, b) + area(b, c) + area(c, a);
  const Spot hit = d.marked("a in space") * (area(b, c) / whole) +
                   d.marked("b in space") * (area(c, a) / whole) +
                   d.marked("c in space") * (area(a, b) / whole);
  CHECK(distance(hit, d.marked("hit")) < 1e-9);
  // All three areas have one sign: the ray goes through the triangle.
  CHECK(area(a, b) * whole > 0);
  CHECK(area(b, c) * whole > 0);
  CHECK(area(c, a) * whole > 0);
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
