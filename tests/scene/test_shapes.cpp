// Tests of common/scene/shapes.hpp, scene/floor.hpp and texture/shape_mappings.hpp: a cylinder, a
// rectangle and a floor, how a picture lies on them, and shadows of what is not convex. How exact
// distances to the floor are, and that a point of it has its height to the bit, tests/extremes
// searches.
#include <doctest.h>

#include <cmath>
#include <numbers>
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

TEST_CASE("a rectangle is met where a finer number meets it, within the stated bound, and left") {
  Dice dice(12);
  int met = 0;
  for (int i = 0; i < 40000; ++i) {
    const auto any_size = [&dice] { return static_cast<double>(dice.power_of_ten(0, 2)); };
    const auto right = dice.direction<long double>();
    const double half_width = any_size(), half_height = any_size();
    const Rectangle frame{.center = point_within(dice, any_size()),
                          .right = number_cast<double>(right) * half_width,
                          .up = number_cast<double>(dice.across(right)) * half_height};
    const Vec3d origin = point_within(dice, any_size());
    const Vec3d aim = frame.center + frame.right * static_cast<double>(dice.uniform(-1.2L, 1.2L)) +
                      frame.up * static_cast<double>(dice.uniform(-1.2L, 1.2L));
    const Ray<double> ray{origin, normalize(aim - origin)};
    const double distance = distance_to(frame, ray);
    const auto normal =
        cross(number_cast<long double>(frame.right), number_cast<long double>(frame.up));
    const long double slant = dot(normal, number_cast<long double>(ray.direction));
    if (std::abs(slant) < 0.0175L * length(normal)) continue;
    const auto to_center =
        number_cast<long double>(frame.center) - number_cast<long double>(origin);
    const long double expected = dot(normal, to_center) / slant;
    const auto off = number_cast<long double>(ray.direction) * expected - to_center;
    const auto part_of = [&](const Vec3d& half) {
      const auto exact = number_cast<long double>(half);
      return std::abs(dot(off, exact) / dot(exact, exact));
    };
    const long double outward = std::max(part_of(frame.right), part_of(frame.up)) - 1;
    if (std::abs(outward) < 1e-9L) continue;
    REQUIRE((distance < infinity<double>()) == (outward < 0));
    if (outward > 0) continue;
    ++met;
    const double lengths = length(origin) + length(frame.center) + half_width + half_height;
    REQUIRE(std::abs(distance - static_cast<double>(expected)) <= 1e-14 * lengths);
    const auto outside = number_cast<long double>(hit_at(frame, ray, distance).outside);
    REQUIRE(dot(outside - number_cast<long double>(frame.center), normal) * slant < 0);
  }
  CHECK(met > 5000);
}

TEST_CASE("a label is neither stretched nor mirrored: its lengths are the cylinder's") {
  const Cylinder can{.center = {1, 2, 3}, .radius = 2, .half_height = 3};
  const CylinderMapping label{can};
  Hit<double> hit;
  const auto at = [&](double turn, double y) {
    const double angle = 2 * std::numbers::pi * turn;
    hit.point = can.center + Vec3d{-2 * std::cos(angle), y, 2 * std::sin(angle)};
    return label(hit);
  };
  CHECK(at(0.25, 0).u == doctest::Approx(0.25).epsilon(1e-15));  // towards +z
  CHECK(at(0, 0).u == 0);
  CHECK(at(0, 0).v == 0.5);
  CHECK(at(0, 3).v == 1);
  CHECK(at(0, -3).v == 0);
  for (int i = 0; i < 14; ++i) {
    const double turn = 0.01 + 0.07 * i;
    CHECK(at(turn, 0.5).u == doctest::Approx(turn).epsilon(1e-14));
    CHECK(at(turn, 1.5).v == doctest::Approx(0.75).epsilon(1e-14));
  }
  const RectangleMapping picture{{.center = {1, 2, 3}, .right = {0, 0, -2}, .up = {0, 3, 0}}};
  hit.point = {1, 3.5, 4};
  const Uv<double> uv = picture(hit);
  CHECK(uv.u == 0.25);
  CHECK(uv.v == 0.75);
}

TEST_CASE(
    "the projections to a cylinder and to a plane are the label of a can and a board's picture") {
  const CylinderMapping label{{.center = {}, .radius = 2, .half_height = 1}};
  const RectangleMapping board{{.center = {}, .right = {1, 0, 0}, .up = {0, 0, -1}}};
  Dice dice;
  for (int i = 0; i < 2000; ++i) {
    const auto direction = number_cast<double>(dice.direction());
    const double from_axis = std::hypot(direction.x, direction.z);
    const double out = 2 / from_axis;
    Hit<double> hit;
    hit.point = {out * direction.x, direction.y, out * direction.z};
    const Uv<double> on_can = label(hit), cylinder = project(Projection::cylinder, direction);
    CHECK(std::abs(on_can.u - cylinder.u) < 1e-15);
    CHECK(std::abs(on_can.v - cylinder.v) < 1e-15);
    hit.point = {direction.x, -1, direction.z};  // straight down
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
      {"from below", 0, {{0, -2, 0}, {0, 1, 0}}, 2},
      {"a floor higher up", 1.5, {{0, 2, 0}, {0, -1, 0}}, Real(0.5)},
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
