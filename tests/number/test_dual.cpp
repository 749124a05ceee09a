// Dual numbers: each function's derivative is the textbook's; values are the plain number's.
#include <doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "number/dual.hpp"
#include "number/kinds/interval.hpp"
#include "number/operations.hpp"
#include "support/lanes.hpp"

namespace texmap::test {
namespace {

/// x, moving by 1 for a step of the first parameter and by 2 for one of the second.
template <class Real>
Dual<Real> moving(const Real& x) {
  return {x, Real(1), Real(2)};
}

TEST_CASE_TEMPLATE("values are those of plain numbers, to the bit", T, float, double, long double) {
  const auto check = [](const std::string& name, const auto& operation) {
    CAPTURE(name);
    Dice dice(5);
    for (int i = 0; i < 200; ++i) {
      const T a = static_cast<T>(dice.any_size(-3, 0));
      const T b = static_cast<T>(dice.any_size(-3, 0));
      REQUIRE(alike(operation(moving(a), moving(b)).value, operation(a, b)));
    }
  };
  for_each_arithmetic(check);
  for_each_choice(check);
  for_each_function(check);
}

TEST_CASE_TEMPLATE("functions have the slopes of the textbook", T, float, double, long double) {
  Dice dice(7);
  for (int i = 0; i < 200; ++i) {
    const T x = static_cast<T>(dice.power_of_ten(-3, 0.5L));
    const Dual<T> y = moving(x);
    const Dual<T> two(T(2));
    struct Row {
      Dual<T> got;
      T slope;
    };
    const Row table[] = {{y * y * y, 3 * x * x},
                         {Dual<T>(T(1)) / y, -1 / (x * x)},
                         {(Dual<T>(T(3)) - y) - -y - y, T(-1)},
                         {sqrt(y), 1 / (2 * std::sqrt(x))},
                         {exp(y), std::exp(x)},
                         {log1p(y), 1 / (1 + x)},
                         {sin(y), std::cos(x)},
                         {cos(y), -std::sin(x)},
                         {power(y, T(2.5)), T(2.5) * std::pow(x, T(1.5))},
                         {atan2(y, two), 2 / (4 + x * x)},
                         {atan2(two, y), -2 / (4 + x * x)},
                         {abs(-y), T(1)},
                         {y - floor(y), T(1)},
                         {max(y, -two), T(1)},
                         {min(y, -two), T(0)}};
    for (const Row& row : table) {
      CAPTURE(&row - table);
      const T few = 8 * std::numeric_limits<T>::epsilon() * std::abs(row.slope);
      REQUIRE(std::abs(row.got.dx - row.slope) <= few);
      REQUIRE(std::abs(row.got.dy - 2 * row.slope) <= 2 * few);
    }
    CHECK(sin(y).value == sin(x));
    CHECK(cos(y).value == cos(x));
    CHECK(power(y, T(2.5)).value == pow(x, T(2.5)));
  }
}

TEST_CASE_TEMPLATE("clamp keeps slopes where it guards against rounding, and not beyond", T, float,
                   double, long double) {
  const auto clamped = [](T x) { return clamp(moving(x), Dual<T>(T(0)), Dual<T>(T(1))); };
  const T step = std::numeric_limits<T>::epsilon();
  for (const T x : {T(0), T(0.5), T(1), T(1) + step}) CHECK(clamped(x).dx == 1);
  for (const T x : {T(1) + 4 * step, T(-0.25)}) CHECK(clamped(x).dx == 0);
  CHECK(clamped(T(1) + step).value == 1);
  CHECK(alike(clamped(std::numeric_limits<T>::quiet_NaN()).value, T(0)));
}

TEST_CASE("a dual of intervals encloses the slope") {
  const Dual<Interval> root = sqrt(Dual<Interval>{Interval(2.0, 2.5), Interval(1), Interval(0)});
  CHECK(root.dx.low() <= 0.5 / std::sqrt(2.5));
  CHECK(root.dx.high() >= 0.5 / std::sqrt(2.0));
  CHECK(root.dx.high() < 0.36);
}

}  // namespace
}  // namespace texmap::test
