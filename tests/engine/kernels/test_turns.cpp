// Tests of common/engine/kernels/turns.hpp: (u, v) by polynomials where they must be exact. How far
// they are off elsewhere is held by test_kernel_plan, tests/exhaustive and tests/proofs.
#include "engine/kernels/turns.hpp"

#include <doctest.h>

#include "number/kinds/pack.hpp"
#include "support/dice.hpp"

#define TEXMAP_KERNEL_NUMBERS float, double, long double, Pack<float>, Pack<double>

namespace texmap::test {
namespace {

/// Zeros, ones, the smallest and the largest numbers, with either sign, and a few between.
template <class Real>
std::vector<Real> hard_finite_numbers() {
  using Limits = std::numeric_limits<Real>;
  std::vector<Real> all = {Limits::epsilon(), Real(1e-30), Real(-1e30)};
  for (const Real size : {Real(0), Real(1), Limits::denorm_min(), Limits::min(), Limits::max()}) {
    all.push_back(size);
    all.push_back(-size);
  }
  return all;
}

TEST_CASE_TEMPLATE("on the axes u is exactly uv_rtiow's, and at the poles v is, too", Real,
                   TEXMAP_KERNEL_NUMBERS) {
  const auto check = [](double x, double y, double z) {
    const Vec3<Real> p{Real(x), Real(y), Real(z)};
    const Uv<Real> exact = uv_rtiow(p);
    const Uv<Real> fast = FastUnitMapping<13>{}(p);
    CAPTURE(x);
    CAPTURE(y);
    CAPTURE(z);
    CHECK(lane(fast.u, 0) == lane(exact.u, 0));
    if (y != 0) CHECK(lane(fast.v, 0) == lane(exact.v, 0));
  };
  for (const double a : {0.0, -0.0}) {
    for (const double b : {0.0, -0.0}) {
      for (const double one : {1.0, -1.0}) {
        check(one, a, b);
        check(a, one, b);
        check(a, b, one);
      }
    }
  }
}

TEST_CASE_TEMPLATE("a turn is in [0, 1) for any finite vector, and only its direction matters",
                   Real, TEXMAP_KERNEL_NUMBERS) {
  using T = Scalar<Real>;
  const auto turn = [](T x, T y) {
    return lane(turn_of_parts<13>(Real(y), abs(Real(x)), Real(x) > Real(0)), lanes<Real> - 1);
  };
  for (const T x : hard_finite_numbers<T>()) {
    for (const T y : hard_finite_numbers<T>()) {
      CAPTURE(x);
      CAPTURE(y);
      REQUIRE(turn(x, y) >= T(0));
      REQUIRE(turn(x, y) < T(1));
    }
  }
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    const T x = static_cast<T>(dice.between(-1, 1)), y = static_cast<T>(dice.between(-1, 1));
    const T size = std::ldexp(T(1), dice.within(-40, 50));
    REQUIRE(turn(x * size, y * size) == turn(x, y));
  }
}

}  // namespace
}  // namespace texmap::test
