// Tests of common/scene/shapes.hpp, scene/floor.hpp and texture/shape_mappings.hpp: a cylinder, a
// rectangle and a floor, how a picture lies on them, and shadows of what is not convex. How exact
// distances to the floor are, and that a point of it has its height to the bit, tests/extremes
// searches.
#include <doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "dice.hpp"
#include "number/kinds/pack.hpp"
#include "sampling/sampled_numbers.hpp"
#include "scene/floor.hpp"
#include "scene/light.hpp"
#include "scene/paint.hpp"
#include "scene/path.hpp"
#include "scene/shapes.hpp"
#include "scene/sky.hpp"
#include "texture/projections.hpp"
#include "texture/shape_mappings.hpp"

namespace texmap::test {
namespace {

static_assert(Shape<Sphere<>> && Shape<AnyShape<Sphere<>, Cylinder, Rectangle>>);

#define NUMBERS float, double, long double, Pack<float>, Pack<double>

template <class Real>
Scalar<Real> first(const Real& x) {
  return lane(x, 0);
}

TEST_CASE_TEMPLATE("rays meet a cylinder and a rectangle where they should", Real, NUMBERS) {
  const Cylinder can{.center = {0, 1, 0}, .radius = 2, .half_height = 3};
  const Rectangle frame{.center = {0, 1, 0}, .right = {2, 0, 0}, .up = {0, 3, 0}};
  const double none = std::numeric_limits<double>::infinity();
  struct Row {
    Point origin;
    Vec3d direction;
    double can, frame;
  };
  const Row rows[] = {
      {{0, 1, 5}, {0, 0, -1}, 3, 5},        // from in front
      {{0, 1, 5}, {0, 0, -2}, 1.5, 2.5},    // in lengths of the direction
      {{0, 1, 5}, {0, 0, 1}, none, none},   // away
      {{0, 1, 0.5}, {0, 0, -1}, 2.5, 0.5},  // from inside
      {{2, 1, 5}, {0, 0, -1}, 5, 5},        // a tangent; a side
      {{2.125, 1, 5}, {0, 0, -1}, none, none},
      {{0, 4, 5}, {0, 0, -1}, 3, 5},  // its upper end
      {{0, 4.125, 5}, {0, 0, -1}, none, none},
      {{0, 5.5, 3}, {0, -1, -1}, 5, 3},     // over the edge to the inner side
      {{0, 9, 0}, {0, -1, 0}, none, none},  // along the axis, and in the plane
      {{0, 9, 5}, {0, 0, 0}, none, none},
      {{0, 1, 5}, {NAN, 0, -1}, none, none},
  };
  for (const Row& row : rows) {
    const Ray<Real> ray{number_cast<Real>(row.origin), number_cast<Real>(row.direction)};
    CAPTURE(row.origin.x);
    CAPTURE(row.origin.y);
    CAPTURE(row.direction.y);
    CHECK(first(distance_to(can, ray)) == static_cast<Scalar<Real>>(row.can));
    CHECK(first(distance_to(frame, ray)) == static_cast<Scalar<Real>>(row.frame));
  }
  // A ray that goes on starts on the side that it came from.
  for (const double side : {1.0, -1.0}) {
    const Ray<Real> ray{{Real(0), Real(1), Real(side)}, {Real(0), Real(0), Real(-side)}};
    CHECK(first(hit_at(frame, ray, Real(1)).outside.z * Real(side)) > 0);
  }
}

TEST_CASE("a cylinder is met first where a finer number meets it, within the stated bounds") {
  constexpr double u = 0x1p-53;
  Dice dice(11);
  int met = 0;
  for (int i = 0; i < 40000; ++i) {
    const double far = static_cast<double>(dice.power_of_ten(0, 2));
    const double size = dice.once_in(2) ? 1 : 100;
    const Cylinder can{point_within(dice, size), size, 0.75 * size};
    const Vec3d origin = point_within(dice, far * size);
    const Ray<double> ray{origin, normalize(can.center + point_within(dice, 1.2 * size) - origin)};
    // The plain quadratic, whose roots are tried one by one.
    const auto o = number_cast<long double>(ray.origin) - number_cast<long double>(can.center);
    const auto d = number_cast<long double>(ray.direction);
    const long double a = d.x * d.x + d.z * d.z, b = o.x * d.x + o.z * d.z;
    const long double c = o.x * o.x + o.z * o.z - size * size, rest = b * b - a * c;
    auto expected = infinity<long double>();
    for (const long double sign : {1.0L, -1.0L}) {
      const long double t = (-b + sign * std::sqrt(rest)) / a;
      if (t > 0 && std::abs(o.y + t * d.y) <= 0.75L * size && t < expected) expected = t;
    }
    const double distance = distance_to(can, ray);
    const long double edge = std::abs(std::abs(o.y + expected * d.y) - 0.75L * size) / size;
    const long double off_axis = 1 - rest / a / (size * size);  // squared
    if (off_axis > 0.998L || edge < 1e-9L || std::abs(c) < 1e-9L * size) continue;
    REQUIRE((distance < infinity<double>()) == (expected < infinity<long double>()));
    if (expected == infinity<long double>()) continue;
    ++met;
    const double lengths = length(origin) + length(can.center) + size;
    REQUIRE(std::abs(distance - static_cast<double>(expected)) <= 1e-14 * lengths);
    const Hit<double> hit = hit_at(can, ray, distance);
    const Vec3d off = hit.point - can.center;
    REQUIRE(std::abs(std::hypot(off.x, off.z) - size) <= 4 * u * (largest(hit.point) + size));
    REQUIRE(dot(hit.normal, ray.direction) <= 0);
    REQUIRE(distance_to(can, Ray<double>{hit.outside, hit.normal}) > size);  // not where it starts
  }
  CHECK(met > 5000);
}

TEST_CASE(
    "the projections to a cylinder and to a plane are the label of a can and a board's picture") {
  const Point center{1, 2, 3};
  const CylinderMapping label{{.center = center, .radius = 2, .half_height = 3}};
  const RectangleMapping board{{.center = center, .right = {2, 0, 0}, .up = {0, 0, -2}}};
  Dice dice;
  for (int i = 0; i < 2000; ++i) {
    const auto direction = number_cast<double>(dice.direction());
    const double out = 2 / std::hypot(direction.x, direction.z);
    Hit<double> hit;
    hit.point = center + Vec3d{out * direction.x, 3 * direction.y, out * direction.z};
    const Uv<double> on_can = label(hit), cylinder = project(Projection::cylinder, direction);
    CHECK(std::abs(on_can.u - cylinder.u) < 1e-15);
    CHECK(std::abs(on_can.v - cylinder.v) < 1e-15);
    hit.point = center + Vec3d{2 * direction.x, -1, 2 * direction.z};  // straight down
    const Uv<double> on_board = board(hit), plane = project(Projection::plane, direction);
    CHECK(std::abs(on_board.u - plane.u) < 1e-15);
    CHECK(std::abs(on_board.v - plane.v) < 1e-15);
  }
}

TEST_CASE("an open cylinder throws a shadow into itself; a sphere and a rectangle cannot") {
  struct Object {
    AnyShape<Sphere<>, Cylinder, Rectangle> shape;
  };
  const PointLight lamp{.position = {6, 3, 0}};
  const auto lit = [&](const auto& shape, const Ray<double>& ray) {
    const std::vector<Object> alone = {{shape}};
    Hit<double> hit = hit_at(alone[0].shape, ray, distance_to(alone[0].shape, ray));
    hit.object = 0;
    return sample_light(lamp, alone, hit).cosine;
  };
  const Cylinder can{.radius = 1, .half_height = 1};
  // From above on its inner side at -x, which faces the lamp: the lamp is over the edge at +x.
  CHECK(lit(can, {{0, 1.5, 0}, {-1, -0.6, 0}}) > 0);   // near the upper end
  CHECK(lit(can, {{0, 1.5, 0}, {-1, -2.4, 0}}) == 0);  // near the lower end
  CHECK(lit(can, {{4, 0, 0}, {-1, 0, 0}}) > 0);        // its outer side
  CHECK(lit(Sphere<>{}, {{4, 0, 0}, {-1, 0, 0}}) > 0);
  CHECK(lit(Rectangle{.right = {0, 0, -1}}, {{4, 0, 0}, {-1, 0, 0}}) > 0);
}

TEST_CASE("a path goes on inside of a cylinder that is alone: its inner side lights itself") {
  struct Object {
    Cylinder shape;
    Solid paint;
  };
  const std::vector<Object> alone = {{{.radius = 1, .half_height = 1}, {gray(0.5)}}};
  const GradientSky sky{.below = {1, 1, 1}, .above = {1, 1, 1}};
  double sum = 0;
  for (std::uint32_t i = 0; i < 4096; ++i) {
    SampledNumbers<double> numbers{{SamplerKind::sobol, 4096}, i};
    sum += light_along(alone, Ray<double>{{0, 0, 0}, {1, 0, 0}}, sky, 50, numbers).g;
  }
  // Half of the light from the sky, a quarter of what came over another point, and so on.
  CHECK(sum / 4096 < 0.42);
  CHECK(sum / 4096 > 0.25);
}

TEST_CASE_TEMPLATE("distances to the floor obey their table: from above, below, along it and on it",
                   Real, float, double, long double) {
  const Real miss = infinity<Real>();
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  struct Row {
    std::string what;
    double height;
    Ray<Real> ray;
    Real distance;
  };
  const Row table[] = {
      {"from above", 0, {{0, 2, 0}, {0, -1, 0}}, 2},
      {"from above, aslant", 0, {{1, 3, 5}, {2, -1, -7}}, 3},
      {"from above, upward", 0, {{0, 2, 0}, {0, 1, 0}}, miss},
      {"along it, above", 0, {{0, 2, 0}, {1, 0, 0}}, miss},
      {"along it, above, with a minus zero", 0, {{0, 2, 0}, {1, -Real(0), 0}}, miss},
      {"on it, along it", 0, {{0, 0, 0}, {1, 0, 0}}, miss},
      {"on it, downward", 0, {{0, 0, 0}, {0, -1, 0}}, miss},
      {"on it, upward", 2, {{0, 2, 0}, {0, 1, 0}}, miss},
      {"without a direction", 0, {{0, 2, 0}, {0, 0, 0}}, miss},
      {"from a height that is no number", 0, {{0, nan, 0}, {0, -1, 0}}, miss},
      {"with a direction that is no number", 0, {{0, 2, 0}, {0, nan, 0}}, miss},
  };
  for (const Row& row : table) {
    CAPTURE(row.what);
    CHECK(distance_to(Floor{row.height}, row.ray) == row.distance);
  }
  CHECK(Floor{}.height == 0);
}

}  // namespace
}  // namespace texmap::test
