// Tests of scene/triangle.hpp, of published/triangle.hpp where it differs, and of
// scene/edge_function.hpp: what a ray sees of corners and edges. That no ray slips between
// triangles, scene/test_mesh.cpp tests, that a corner has all weight at its own place,
// texture/test_mesh_mapping.cpp; how exact places and weights are, of needles too, which triangles
// count as none, and that sides of edges are exact, tests/extremes searches.
#include <doctest.h>

#include <cmath>

#include "number/dual.hpp"
#include "published/triangle.hpp"
#include "scene/edge_function.hpp"
#include "support/dice.hpp"

namespace texmap::test {
namespace {

template <class Real>
bool is(const Barycentric<Real>& w, double a, double b, double c) {
  return !w.degenerate && w.a == Real(a) && w.b == Real(b) && w.c == Real(c);
}

const Triangle right_triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST_CASE_TEMPLATE("P24: in the middle of a side the weights are 1/2, 1/2 and 0, to the bit", Real,
                   float, double, long double) {
  Dice dice;
  const Real third = Real(1) / Real(3);
  for (int i = 0; i < 5000; ++i) {
    // Multiples of 6, so that every number holds the middles and the centroid.
    const int range = i % 2 == 0 ? 16 : 1000000;
    const Triangle t{whole_point_within(dice, range) * 6.0, whole_point_within(dice, range) * 6.0,
                     whole_point_within(dice, range) * 6.0};
    if (barycentric(t, number_cast<Real>(t.a)).degenerate) continue;
    REQUIRE(is(barycentric(t, number_cast<Real>(t.a)), 1, 0, 0));
    REQUIRE(is(barycentric(t, number_cast<Real>(t.b)), 0, 1, 0));
    REQUIRE(is(barycentric(t, number_cast<Real>(t.c)), 0, 0, 1));
    REQUIRE(is(barycentric(t, number_cast<Real>((t.a + t.b) * 0.5)), 0.5, 0.5, 0));
    REQUIRE(is(barycentric(t, number_cast<Real>((t.b + t.c) * 0.5)), 0, 0.5, 0.5));
    REQUIRE(is(barycentric(t, number_cast<Real>((t.c + t.a) * 0.5)), 0.5, 0, 0.5));
    const Barycentric<Real> w = barycentric(t, number_cast<Real>((t.a + t.b + t.c) * (1.0 / 3)));
    REQUIRE(largest(Vec3<Real>{w.a - third, w.b - third, w.c - third}) <=
            Real(0.5) * unit_roundoff<Real>());  // one step of the numbers from 1/4 to 1/2
  }
}

TEST_CASE_TEMPLATE("P25: beyond a side a weight is negative, not folded back inside", Real, float,
                   double, long double) {
  CHECK(is(barycentric(right_triangle, Vec3<Real>{-1, 0, 0}), 2, -1, 0));
  CHECK(is(barycentric(right_triangle, Vec3<Real>{0, -1, 0}), 2, 0, -1));
  CHECK(is(barycentric(right_triangle, Vec3<Real>{1, 1, 0}), -1, 1, 1));
  CHECK(is(barycentric(right_triangle, Vec3<Real>{-2, -3, 0}), 6, -2, -3));
  // The other way round, and in the other two planes.
  CHECK(is(barycentric({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, Vec3<Real>{-1, 0, 0}), 2, 0, -1));
  CHECK(is(barycentric({{0, 0, 0}, {0, 0, 1}, {0, 1, 0}}, Vec3<Real>{0, -1, 0}), 2, 0, -1));
  CHECK(is(barycentric({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, Vec3<Real>{-1, 0, 0}), 2, -1, 0));
}

TEST_CASE("of a triangle that is none all the weight is the first corner's, in any order") {
  for (const Triangle& line :
       {Triangle{{4, 5, 7}, {1, 2, 3}, {1, 2, 3}}, Triangle{{1, 0, 0}, {0, 0, 0}, {2, 0, 0}}}) {
    const Barycentric<double> w = barycentric(line, Point{0.25, -7, 1e6});
    CHECK(w.degenerate);
    CHECK((w.a == 1 && w.b == 0 && w.c == 0));
  }
}

TEST_CASE_TEMPLATE("off the plane the weights are those of the foot", Real, float, double,
                   long double) {
  for (const double height : {1e-6, 0.5, 7.0, 1e6})
    CHECK(is(barycentric(right_triangle, Vec3<Real>{Real(0.25), Real(0.25), Real(height)}), 0.5,
             0.25, 0.25));
}

TEST_CASE_TEMPLATE(
    "the triangle article takes a point beyond a side for one inside, because areas have no sign",
    Real, float, double, long double) {
  const Barycentric<Real> w = published::barycentric_heron(right_triangle, Vec3<Real>{-1, 0, 0});
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
