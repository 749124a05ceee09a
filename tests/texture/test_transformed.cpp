// Tests of common/texture/transformed.hpp: (u, v) scaled, turned and moved.
#include "texture/transformed.hpp"

#include <doctest.h>

#include "math/rotation.hpp"
#include "number/dual.hpp"
#include "number/kinds/interval.hpp"
#include "texture/conventions.hpp"

namespace texmap::test {
namespace {

struct Row {
  Uv<double> scale;
  double degrees;
  Uv<double> offset;
  Uv<double> at, moved;
};

constexpr Row exact_rows[] = {
    {{1, 1}, 0, {0, 0}, {0.25, 0.75}, {0.25, 0.75}},
    {{2, 3}, 0, {0, 0}, {0.25, 0.75}, {0.5, 2.25}},
    {{-1, 1}, 0, {1, 0}, {0.25, 0.75}, {0.75, 0.75}},
    {{1, 1}, 0, {0.25, -1}, {0.25, 0.75}, {0.5, -0.25}},
    // A quarter turn takes the u axis to the v axis, and v to -u; (0, 0) stays.
    {{1, 1}, 90, {0, 0}, {0, 0}, {0, 0}},
    {{1, 1}, 90, {0, 0}, {1, 0}, {0, 1}},
    {{1, 1}, 90, {0, 0}, {0.25, 0.75}, {-0.75, 0.25}},
    {{1, 1}, 450, {0, 0}, {0.25, 0.75}, {-0.75, 0.25}},
    {{1, 1}, 180, {0, 0}, {0.25, 0.75}, {-0.25, -0.75}},
    // All three: scaled to (0.5, 0.75), turned to (-0.75, 0.5), moved.
    {{2, 1}, 90, {0.25, 0.125}, {0.25, 0.75}, {-0.5, 0.625}},
};

UvTransform transform_of(const Row& row) {
  return {row.scale, on_circle_of_degrees(row.degrees), row.offset};
}

TEST_CASE_TEMPLATE("exact places: first scaled, then turned about (0, 0), then moved", Real, float,
                   double, long double) {
  for (const Row& row : exact_rows) {
    CAPTURE(row.degrees);
    const Uv<Real> uv = transform_of(row)(Uv<Real>{Real(row.at.u), Real(row.at.v)});
    CHECK(uv.u == Real(row.moved.u));
    CHECK(uv.v == Real(row.moved.v));
  }
}

TEST_CASE("derivatives are scaled and turned with (u, v), and intervals contain the place") {
  const Row row{{3, 2}, 90, {0.5, 7}, {0.25, 0.75}, {-1, 7.75}};
  const UvTransform transform = transform_of(row);
  const auto moved = transform(Uv<Dual<double>>{{0.25, 1, 0}, {0.75, 0, 1}});
  CHECK(moved.u.value == -1);
  CHECK(moved.u.dx == 0);
  CHECK(moved.u.dy == -2);
  CHECK(moved.v.dx == 3);
  CHECK(moved.v.dy == 0);
  const auto bounds = transform(Uv<Interval>{Interval(0.25), Interval(0.75)});
  CHECK(bounds.u.low() <= -1);
  CHECK(bounds.u.high() >= -1);
  CHECK(bounds.u.high() - bounds.u.low() < 1e-14);
}

TEST_CASE("any mapping can be transformed; without a transform it is the mapping itself") {
  const Vec3d p{0.3, -0.2, 0.9};
  const ConventionMapping mapping{Convention::lecture};
  const Uv<double> plain = mapping(p);
  const Uv<double> same = Transformed<ConventionMapping>{{}, mapping}(p);
  const Uv<double> twice = Transformed<ConventionMapping>{UvTransform{.scale = {2, 1}}, mapping}(p);
  CHECK(same.u == plain.u);
  CHECK(same.v == plain.v);
  CHECK(twice.u == 2 * plain.u);
  CHECK(twice.v == plain.v);
}

}  // namespace
}  // namespace texmap::test
