// Tests of common/texture/uv.hpp: the map from a direction to (u, v).
#include <doctest.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "number/kinds/pack.hpp"
#include "support/exact.hpp"
#include "support/hard_vectors.hpp"
#include "texture/uv.hpp"

namespace texmap::test {
namespace {

constexpr Exact exact_pi = 3.14159265358979323846264338327950288L;

/// The largest difference from (u, v) in any lane, in epsilons.
template <class Real>
double off(const Uv<Real>& uv, Exact u, Exact v) {
  constexpr auto epsilon = static_cast<Exact>(std::numeric_limits<Scalar<Real>>::epsilon());
  Exact worst = 0;
  for (std::size_t i = 0; i < lanes<Real>; ++i) {
    const Exact off_u = abs(static_cast<Exact>(lane(uv.u, i)) - u);
    const Exact off_v = abs(static_cast<Exact>(lane(uv.v, i)) - v);
    if (!(off_u <= 1 && off_v <= 1)) return 1e30;
    worst = std::max({worst, off_u / epsilon, off_v / epsilon});
  }
  return static_cast<double>(worst);
}

#define NUMBERS float, double, long double, Pack<float>, Pack<double>

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
      {-0.0, 0, 1, 0.25, 0.5}, {-0.0, -0.0, -1, 0.75, 0.5},
  };
  for (const Row& row : table) {
    for (const double length : {1.0, 0.375, 1e-30, 1e30}) {
      CAPTURE(row.x);
      CAPTURE(row.y);
      CAPTURE(row.z);
      CAPTURE(length);
      CHECK(off(uv_rtiow(
                    Vec3<Real>{Real(row.x * length), Real(row.y * length), Real(row.z * length)}),
                widened(row.u), widened(row.v)) == 0);
    }
  }
}

TEST_CASE_TEMPLATE("known angles have their places", Real, NUMBERS) {
  constexpr Exact root2 = 1.41421356237309504880168872420969808L;
  constexpr Exact root3 = 1.73205080756887729352744634150587237L;
  struct Row {
    Exact x, y, z, u, v;
  };
  const Row table[] = {
      {1, 0, 1, 0.375L, 0.5L},
      {-1, 0, 1, 0.125L, 0.5L},
      {1, 0, -1, 0.625L, 0.5L},
      {-1, 0, -1, 0.875L, 0.5L},
      {1 / root2, 0, 1 / root2, 0.375L, 0.5L},
      {1, 1, 0, 0.5L, 0.75L},
      {0, -1, 1, 0.25L, 0.25L},
      {1, root2, -1, 0.625L, 0.75L},
      {-1, -root2, 1, 0.125L, 0.25L},
      {root3, 0, 1, 5 / widened(12), 0.5L},
      {1, 0, root3, 1 / widened(3), 0.5L},
      {0, root3, -1, 0.75L, 5 / widened(6)},
      {0, 1, -root3, 0.75L, 2 / widened(3)},
      {1, 2, 3, 0.30120819117478336L, 0.67950851798568805L},
  };
  for (const Row& row : table) {
    CAPTURE(row.u);
    CAPTURE(row.v);
    const auto number = [](Exact x) { return Real(static_cast<Scalar<Real>>(x)); };
    // The last row is published with 17 digits.
    const double step = static_cast<double>(std::numeric_limits<Scalar<Real>>::epsilon());
    const double digits = row.y == 2 ? std::max(1e-16 / step, 1.0) : 1;
    CHECK(off(uv_rtiow(Vec3<Real>{number(row.x), number(row.y), number(row.z)}), row.u, row.v) <=
          digits);
  }
}

TEST_CASE_TEMPLATE(
    "u is below 1 and v from 0 to 1 for every vector, the smallest, largest and no numbers too",
    Real, float, double, long double) {
  std::vector<Real> coordinates = test::hard_finite_numbers<Real>();
  coordinates.insert(coordinates.end(),
                     {infinity<Real>(), -infinity<Real>(), std::numeric_limits<Real>::quiet_NaN()});
  test::check_every_place([](const Vec3<Real>& p) { return uv_rtiow(p); }, coordinates);
}

TEST_CASE_TEMPLATE("a step beyond the pole is still the pole", Real, NUMBERS) {
  const Real beyond = Real(std::nextafter(Scalar<Real>(1), Scalar<Real>(2)));
  CHECK(off(uv_rtiow(Vec3<Real>{Real(0), beyond, Real(0)}), 0.5L, 1) == 0);
  CHECK(off(uv_rtiow(Vec3<Real>{Real(0), -beyond, Real(0)}), 0.5L, 0) == 0);
}

TEST_CASE_TEMPLATE("the zero vector is in the middle", Real, NUMBERS) {
  CHECK(off(uv_rtiow(Vec3<Real>{Real(0), Real(0), Real(0)}), 0.5L, 0.5L) == 0);
  CHECK(off(uv_rtiow(Vec3<Real>{-Real(0), -Real(0), -Real(0)}), 0.5L, 0.5L) == 0);
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
    // Powers of two round nothing.
    const Uv<Real> doubled = uv_rtiow(p * Real(1024));
    REQUIRE(doubled.u == uv.u);
    REQUIRE(doubled.v == uv.v);
  }
}

TEST_CASE("both sides of the seam keep their digits") {
  CHECK(abs(uv_rtiow(Point{-1, 0, 1e-9}).u - 1.5915494309189534e-10) <= 1.2e-16);
  CHECK(abs(uv_rtiow(Point{-1, 0, -1e-9}).u - 0.99999999984084506) <= 1.2e-16);
  CHECK(uv_rtiow(Point{-1, 0, -1e-30}).u == below_one<double>());
  CHECK(uv_rtiow(Point{-1, 0, 1e-30}).u == 0);
}

/// The reference: other formulas, and the digits of long double.
template <class Real>
Uv<Exact> reference(const Vec3<Real>& p) {
  const Exact x = widened(p.x);
  const Exact y = widened(p.y);
  const Exact z = widened(p.z);
  const Exact u = atan2(z, -x) / (2 * exact_pi);
  return {u < 0 ? u + 1 : u, atan2(std::hypot(x, z), -y) / exact_pi};
}

TEST_CASE_TEMPLATE("clamp_u brings every number into the half-open range", Real, NUMBERS) {
  const auto clamped = [](double u) { return lane(clamp_u(Real(u)), lanes<Real> - 1); };
  using T = Scalar<Real>;
  CHECK(clamped(0) == T(0));
  CHECK(clamped(0.75) == T(0.75));
  CHECK(clamped(-1e-9) == T(0));
  CHECK(clamped(1) == std::nextafter(T(1), T(0)));
  CHECK(clamped(2) == std::nextafter(T(1), T(0)));
  CHECK(clamped(std::numeric_limits<double>::quiet_NaN()) == T(0));
  CHECK(lane(clamp_u(below_one<Real>()), 0) == below_one<T>());
}

}  // namespace
}  // namespace texmap::test
