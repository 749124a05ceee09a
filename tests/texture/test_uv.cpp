// Tests of common/texture/uv.hpp: the map from a direction to (u, v). How exact it is, and that no
// vector's place is outside [0, 1), tests/extremes searches.
#include <doctest.h>

#include <cmath>
#include <numbers>

#include "number/dual.hpp"
#include "number/kinds/pack.hpp"
#include "texture/uv.hpp"

namespace texmap::test {
namespace {

#define NUMBERS float, double, long double, Pack<float>, Pack<double>

/// True if the last lane is exactly (u, v).
template <class Real>
bool is(const Uv<Real>& uv, double u, double v) {
  const std::size_t last = lanes<Real> - 1;
  return lane(uv.u, last) == static_cast<Scalar<Real>>(u) &&
         lane(uv.v, last) == static_cast<Scalar<Real>>(v);
}

TEST_CASE_TEMPLATE("the axes have their exact places, whatever the vector's length", Real,
                   NUMBERS) {
  struct Row {
    double x, y, z, u, v;
  };
  const Row table[] = {
      {-1, 0, 0, 0, 0.5},      {0, 0, 1, 0.25, 0.5},        {1, 0, 0, 0.5, 0.5},
      {0, 0, -1, 0.75, 0.5},   {0, 1, 0, 0.5, 1},           {0, -1, 0, 0.5, 0},
      {-1, 0, -0.0, 0, 0.5},   {-0.0, 1, -0.0, 0.5, 1},     {-0.0, 1, 0, 0.5, 1},
      {0, 1, -0.0, 0.5, 1},    {-0.0, -1, 0, 0.5, 0},       {1, -0.0, -0.0, 0.5, 0.5},
      {-0.0, 0, 1, 0.25, 0.5}, {-0.0, -0.0, -1, 0.75, 0.5}, {0, 0, 0, 0.5, 0.5},
  };
  for (const Row& row : table) {
    for (const double length : {1.0, 0.375, 1e-30, 1e30}) {
      CAPTURE(row.x);
      CAPTURE(row.y);
      CAPTURE(row.z);
      CAPTURE(length);
      const Vec3<Real> p{Real(row.x * length), Real(row.y * length), Real(row.z * length)};
      CHECK(is(uv_rtiow(p), row.u, row.v));
    }
  }
}

TEST_CASE_TEMPLATE("a step beyond the pole is still the pole", Real, NUMBERS) {
  const Real beyond = Real(std::nextafter(Scalar<Real>(1), Scalar<Real>(2)));
  CHECK(is(uv_rtiow(Vec3<Real>{Real(0), beyond, Real(0)}), 0.5, 1));
  CHECK(is(uv_rtiow(Vec3<Real>{Real(0), -beyond, Real(0)}), 0.5, 0));
}

TEST_CASE_TEMPLATE("only the direction matters", Real, float, double, long double) {
  const Real tolerance = Real(8) * std::numeric_limits<Real>::epsilon();
  for (int i = 0; i < 2000; ++i) {
    const Vec3<Real> p{std::sin(static_cast<Real>(i)), std::cos(static_cast<Real>(2 * i + 1)),
                       std::sin(static_cast<Real>(3 * i + 2))};
    const Uv<Real> uv = uv_rtiow(p);
    for (const Real k : {Real(1e-30L), Real(0.3L), Real(1e30L)}) {
      const Uv<Real> other = uv_rtiow(p * k);
      REQUIRE(abs(other.u - uv.u) <= tolerance);
      REQUIRE(abs(other.v - uv.v) <= tolerance);
    }
  }
}

TEST_CASE("v has the slopes of its formula where |x| = |z|, too") {
  // v = 1/2 + asin(y / |p|) / pi: the slope along x is -x y / (pi wide |p|^2), wide^2 = x^2 + z^2.
  for (const double x : {1.0, -1.0}) {
    for (const double z : {1.0, -1.0, 0.5, -2.0}) {
      const double y = 0.8, wide = std::hypot(x, z), squared = x * x + y * y + z * z;
      const Dual<double> v = uv_rtiow(Vec3<Dual<double>>{{x, 1, 0}, y, {z, 0, 1}}).v;
      CHECK(v.dx == doctest::Approx(-x * y / (std::numbers::pi * wide * squared)).epsilon(1e-14));
      CHECK(v.dy == doctest::Approx(-z * y / (std::numbers::pi * wide * squared)).epsilon(1e-14));
    }
  }
}

}  // namespace
}  // namespace texmap::test
