// Tests of common/number/number.hpp: what the course asks of a plain number.
#include <doctest.h>

#include <type_traits>

#include "number/number.hpp"

namespace texmap::test {

TEST_CASE_TEMPLATE("a plain number is a pack of one lane, with the constants of its type", Real,
                   float, double, long double) {
  static_assert(lanes<Real> == 1);
  static_assert(std::is_same_v<Scalar<Real>, Real>);
  static_assert(std::is_same_v<Mask<Real>, bool>);
  CHECK(lane(Real(7), 0) == Real(7));
  CHECK(from_lanes<Real>([](std::size_t i) { return Real(5) + static_cast<Real>(i); }) == Real(5));
  CHECK(any(true));
  CHECK_FALSE(any(false));
  CHECK(infinity<Real>() > std::numeric_limits<Real>::max());
  CHECK(below_one<Real>() == std::nextafter(Real(1), Real(0)));
  const Real u = unit_roundoff<Real>();  // the largest number that vanishes when added to 1
  CHECK(Real(1) + u == Real(1));
  CHECK(Real(1) + std::nextafter(u, Real(1)) > Real(1));
}

TEST_CASE_TEMPLATE("the functions of a number keep its type and their exact points", Real, float,
                   double, long double) {
  const Real inf = infinity<Real>();
  const Real nan = std::numeric_limits<Real>::quiet_NaN();  // on the left: the right is the answer
  const Real next = std::nextafter(Real(2), Real(3));
  const auto brought = [](Real x) { return clamp(x, Real(-1), Real(2)); };
  struct Row {
    Real got, right;
  };
  const Row table[] = {{max(Real(1), Real(2)), 2},
                       {max(Real(2), Real(1)), 2},
                       {max(-inf, inf), inf},
                       {max(nan, Real(4)), 4},
                       {min(Real(1), Real(2)), 1},
                       {min(Real(2), Real(1)), 1},
                       {min(-inf, inf), -inf},
                       {min(nan, Real(4)), 4},
                       {brought(-inf), -1},
                       {brought(-2), -1},
                       {brought(Real(-0.5)), Real(-0.5)},
                       {brought(next), 2},
                       {brought(inf), 2},
                       {brought(nan), -1},
                       {square(Real(-3)), 9},
                       {abs(Real(-2)), 2},
                       {sqrt(Real(6.25)), Real(2.5)},
                       {floor(Real(-0.5)), -1},
                       {floor(Real(2.75)), 2},
                       {atan2(Real(0), Real(-1)), pi<Real>()},
                       {exp(Real(0)), 1},
                       {log1p(Real(0)), 0},
                       {power(Real(9), Real(1.5)), 27}};
  for (const Row& row : table) CHECK(row.got == row.right);
  static_assert(std::is_same_v<decltype(sqrt(Real(2))), Real>);
  static_assert(std::is_same_v<decltype(atan2(Real(2), Real(1))), Real>);
  static_assert(std::is_same_v<decltype(exp(Real(2))), Real>);
  static_assert(std::is_same_v<decltype(log1p(Real(2))), Real>);
}

}  // namespace texmap::test
