// Tests of common/number/number.hpp: what the course asks of a plain number.
#include <doctest.h>

#include "number/number.hpp"

namespace texmap::test {
namespace {

TEST_CASE_TEMPLATE("infinity is above every finite number", Real, float, double, long double) {
  CHECK(infinity<Real>() > std::numeric_limits<Real>::max());
  CHECK(infinity<Real>() / Real(2) == infinity<Real>());
}

TEST_CASE_TEMPLATE("below_one is the last number before one", Real, float, double, long double) {
  CHECK(below_one<Real>() == std::nextafter(Real(1), Real(0)));
}

TEST_CASE_TEMPLATE("the unit roundoff is the largest number that vanishes when added to one", Real,
                   float, double, long double) {
  const Real u = unit_roundoff<Real>();
  CHECK(Real(1) + u == Real(1));
  CHECK(Real(1) + std::nextafter(u, Real(1)) > Real(1));
}

TEST_CASE_TEMPLATE("a plain number is a pack of one lane", Real, float, double, long double) {
  static_assert(lanes<Real> == 1);
  static_assert(std::is_same_v<Scalar<Real>, Real>);
  static_assert(std::is_same_v<Mask<Real>, bool>);
  CHECK(lane(Real(7), 0) == Real(7));
  CHECK(from_lanes<Real>([](std::size_t i) { return Real(5) + static_cast<Real>(i); }) == Real(5));
  CHECK(any(true));
  CHECK_FALSE(any(false));
}

TEST_CASE_TEMPLATE("larger and smaller obey their table", Real, float, double, long double) {
  const Real inf = infinity<Real>();
  struct Row {
    Real a, b, large, small;
  };
  const Row table[] = {
      {1, 2, 2, 1}, {2, 1, 2, 1},           {-1, 1, 1, -1},   {-2, -1, -1, -2},
      {3, 3, 3, 3}, {-inf, inf, inf, -inf}, {0, inf, inf, 0}, {-inf, 0, 0, -inf},
  };
  for (const Row& row : table) {
    CHECK(max(row.a, row.b) == row.large);
    CHECK(min(row.a, row.b) == row.small);
  }
  const Real nan = std::numeric_limits<Real>::quiet_NaN();  // on the left: the right is the answer
  CHECK(max(nan, Real(4)) == Real(4));
  CHECK(min(nan, Real(4)) == Real(4));
}

TEST_CASE_TEMPLATE("clamp obeys its table and makes a NaN the lower bound", Real, float, double,
                   long double) {
  const Real inf = infinity<Real>();
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Real next = std::nextafter(Real(2), Real(3));
  struct Row {
    Real x, brought;
  };
  const Row table[] = {
      {-inf, -1}, {-2, -1}, {-1, -1},  {Real(-0.5), Real(-0.5)}, {0, 0}, {2, 2}, {next, 2},
      {3, 2},     {inf, 2}, {nan, -1},
  };
  for (const Row& row : table) CHECK(clamp(row.x, Real(-1), Real(2)) == row.brought);
}

TEST_CASE_TEMPLATE("square multiplies a number with itself", Real, float, double, long double) {
  CHECK(square(Real(-3)) == Real(9));
  CHECK(square(Real(0.5)) == Real(0.25));
  CHECK(square(std::numeric_limits<Real>::max()) == infinity<Real>());
}

TEST_CASE_TEMPLATE("the functions of a number keep its type and their exact points", Real, float,
                   double, long double) {
  static_assert(std::is_same_v<decltype(sqrt(Real(2))), Real>);
  static_assert(std::is_same_v<decltype(atan2(Real(2), Real(1))), Real>);
  static_assert(std::is_same_v<decltype(exp(Real(2))), Real>);
  static_assert(std::is_same_v<decltype(log1p(Real(2))), Real>);
  CHECK(abs(Real(-2)) == Real(2));
  CHECK(abs(Real(-0.5)) == Real(0.5));
  CHECK(sqrt(Real(6.25)) == Real(2.5));
  CHECK(floor(Real(-0.5)) == Real(-1));
  CHECK(floor(Real(2.75)) == Real(2));
  CHECK(atan2(Real(0), Real(-1)) == pi<Real>());
  CHECK(exp(Real(0)) == Real(1));
  CHECK(log1p(Real(0)) == Real(0));
}

}  // namespace
}  // namespace texmap::test
