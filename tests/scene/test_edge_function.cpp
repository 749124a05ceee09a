// Tests of scene/edge_function.hpp: what a ray sees of corners and edges. That no ray slips between
// triangles, scene/test_mesh.cpp tests, that a corner has all weight at its own place,
// texture/test_mesh_mapping.cpp; how exact places are, and that sides of edges are, tests/extremes
// searches.
#include <doctest.h>

#include "number/dual.hpp"
#include "scene/edge_function.hpp"

namespace texmap::test {
namespace {

TEST_CASE("on an edge with depths 1 and 3, the middle of the screen is a quarter of the edge") {
  // The middle of the picture of the edge from (-1, 0, -1) to (3, 0, -3) is straight ahead.
  const RaySpace<double> space(Ray<double>{{0, 0, 0}, {0, 0, -1}});
  const auto with_third = [&](const Point& c) {
    return crossing(space, seen_along(space, Point{-1, 0, -1}), seen_along(space, Point{3, 0, -3}),
                    seen_along(space, c));
  };
  const Crossing<double> above = with_third({0, 9, -1});
  const Crossing<double> below = with_third({0, -9, -1});
  REQUIRE(above.met != below.met);  // the edge belongs to one of the two triangles
  const Crossing<double> found = above.met ? above : below;
  CHECK(found.a == 0.75);  // z0 / (z0 + z1) = 1/4 of the way from a to b
  CHECK(found.b == 0.25);
  CHECK(found.c == 0);
  CHECK(found.distance == 1.5);
}

TEST_CASE("a corner that is NaN, a direction that is zero or NaN: nothing is met") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Point a{-1, -1, -2}, b{1, -1, -2}, c{0, 1, -2};
  const auto meets = [&](const Vec3d& direction, const Point& first) {
    const RaySpace<double> space(Ray<double>{{0, 0, 0}, direction});
    return crossing(space, seen_along(space, first), seen_along(space, b), seen_along(space, c))
        .met;
  };
  CHECK(meets({0, 0, -1}, a));
  CHECK_FALSE(meets({0, 0, 0}, a));
  CHECK_FALSE(meets({0, 0, nan}, a));
  CHECK_FALSE(meets({0, 0, -1}, {nan, -1, -2}));
}

TEST_CASE("a ray exactly through a corner: the value 0 has derivatives all the same") {
  const RaySpace<Dual<double>> space(
      Ray<Dual<double>>{{}, {Dual<double>{0, 1, 0}, Dual<double>{0, 0, 1}, Dual<double>(-1)}});
  const auto seen = seen_along(space, Vec3<Dual<double>>{{}, {}, Dual<double>(-4)});
  CHECK(seen.x.value == 0);
  CHECK(seen.x.dx == 4);
}

TEST_CASE_TEMPLATE("numbers with products that would underflow are 0, all others stay", Real, float,
                   double, long double) {
  using Limits = std::numeric_limits<Real>;
  const Real least = std::ldexp(Real(1), (Limits::min_exponent + Limits::digits) / 2);
  CHECK(snapped(least) == least);
  CHECK(snapped(-least) == -least);
  CHECK(snapped(std::nextafter(least, Real(0))) == Real(0));
  // The least product has a rounding error that the number can still hold.
  const Real odd = least * (Real(1) + Limits::epsilon());
  const TwoParts<Real> product = two_product(odd, odd);
  CHECK(product.low == least * least * Limits::epsilon() * Limits::epsilon());
}

}  // namespace
}  // namespace texmap::test
