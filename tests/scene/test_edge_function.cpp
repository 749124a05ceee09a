// Tests of scene/edge_function.hpp: what a ray sees of corners, edges and triangles; and of
// published/triangle.hpp where it differs. That no ray slips between triangles, scene/test_mesh.cpp
// tests; that a corner has all weight at its own place, texture/test_mesh_mapping.cpp; how exact
// places, sides and weights are, of needles too, tests/extremes searches.
#include <doctest.h>

#include <array>
#include <cmath>

#include "number/dual.hpp"
#include "published/triangle.hpp"
#include "scene/edge_function.hpp"
#include "support/dice.hpp"

namespace texmap::test {
namespace {

/// What a ray meets of a triangle straight down, through the point with these x and y.
template <class Real>
Crossing<Real> below(const std::array<Point, 3>& corners, const Point& p) {
  const RaySpace<Real> space(Ray<Real>{number_cast<Real>(Point{p.x, p.y, 0}), {0, 0, -1}});
  const auto seen = [&](std::size_t i) { return seen_along(space, number_cast<Real>(corners[i])); };
  return crossing(space, seen(0), seen(1), seen(2));
}

TEST_CASE_TEMPLATE("P24: in the middle of a side the weights are 1/2, 1/2 and 0, to the bit", Real,
                   float, double, long double) {
  Dice dice;
  const Real third = Real(1) / Real(3);
  int met = 0;
  for (int i = 0; i < 5000; ++i) {
    // Multiples of 6, so that every number holds the middles and the centroid.
    const int range = i % 2 == 0 ? 16 : 1000;
    const auto any = [&] { return whole_point_within(dice, range) * 6.0; };
    const std::array corners{any(), any(), any()};
    const auto& [a, b, c] = corners;
    const Crossing<Real> middle = below<Real>(corners, (a + b + c) * (1.0 / 3));
    if (!middle.met) continue;  // no area from here
    REQUIRE(largest(Vec3<Real>{middle.a - third, middle.b - third, middle.c - third}) <=
            Real(0.5) * unit_roundoff<Real>());  // one step of the numbers from 1/4 to 1/2
    const auto is = [&](const Point& p, double at_a, double at_b, double at_c) {
      const Crossing<Real> w = below<Real>(corners, p);
      if (!w.met) return true;  // then the triangle across the edge is met
      ++met;
      return w.a == Real(at_a) && w.b == Real(at_b) && w.c == Real(at_c);
    };
    REQUIRE(is(a, 1, 0, 0));
    REQUIRE(is(b, 0, 1, 0));
    REQUIRE(is(c, 0, 0, 1));
    REQUIRE(is((a + b) * 0.5, 0.5, 0.5, 0));
    REQUIRE(is((b + c) * 0.5, 0, 0.5, 0.5));
    REQUIRE(is((c + a) * 0.5, 0.5, 0, 0.5));
  }
  CHECK(met > 8000);
}

TEST_CASE_TEMPLATE("P25: beyond a side there is no triangle, and P26: nor on corners in a line",
                   Real, float, double, long double) {
  const std::array<Point, 3> corners{{{0, 0, -1}, {1, 0, -1}, {0, 1, -1}}};
  CHECK(below<Real>(corners, {0.25, 0.25, 0}).met);
  for (const Point& p : {Point{-1, 0, 0}, Point{0, -1, 0}, Point{1, 1, 0}, Point{-2, -3, 0}})
    CHECK_FALSE(below<Real>(corners, p).met);
  for (const double at : {0.0, 0.5, 1.0, 2.0, 3.0}) {
    CHECK_FALSE(below<Real>({{{0, 0, -1}, {1, 1, -1}, {2, 2, -1}}}, {at, at, 0}).met);
    CHECK_FALSE(below<Real>({{{0, 0, -1}, {2, 2, -1}, {2, 2, -1}}}, {at, at, 0}).met);
  }
}

TEST_CASE_TEMPLATE(
    "the triangle article takes a point beyond a side for one inside, because areas have no sign",
    Real, float, double, long double) {
  const auto w = published::barycentric_heron<Real>({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0});
  const Real tolerance = Real(4) * unit_roundoff<Real>();
  CHECK(abs(w.a - Real(2)) <= tolerance);
  CHECK(abs(w.b - Real(1)) <= tolerance);  // -1 in truth
  CHECK(abs(w.c + Real(2)) <= tolerance);  // 0 in truth
}

TEST_CASE("Kahan's needle: in float Heron's formula finds no area at all") {
  CHECK(published::heron_area(3.0F, 4.0F, 5.0F) == 6);
  CHECK(published::heron_area(100000.0F, 99999.99979F, 0.00029F) == 0);
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
