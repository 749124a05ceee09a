// Tests of number/kinds/elementary.hpp: the special cases. tests/extremes measures the errors.
#include <doctest.h>

#include <cmath>
#include <vector>

#include "number/number.hpp"
#include "support/lanes.hpp"

namespace texmap::test {
namespace {

/// Numbers at which these functions have a case of their own, with either sign.
template <class T>
std::vector<T> special_numbers() {
  using Limits = std::numeric_limits<T>;
  std::vector<T> all = {Limits::quiet_NaN()};
  const T digits =
      T(1) / Limits::epsilon();  // 2 digits is even, digits + 1 odd, digits / 4 + 1/2 no integer
  for (const T x : {T(0), T(0.5), T(1), T(2), T(2.5), T(3), T(-1) + Limits::epsilon(), digits * 2,
                    digits + 1, digits / 4 + T(0.5), Limits::min(), Limits::max(),
                    Limits::denorm_min(), Limits::epsilon(), infinity<T>()}) {
    all.push_back(x);
    all.push_back(-x);
  }
  return all;
}

/// The same zero, infinity or NaN; of other numbers the same to a millionth.
template <class T>
bool agrees(T ours, T std_result) {
  if (std_result == std_result && std_result != T(0) && abs(std_result) < infinity<T>())
    return abs(ours - std_result) <=
           abs(std_result) * T(1e-6) + std::numeric_limits<T>::denorm_min();
  return alike(ours, std_result);
}

TEST_CASE_TEMPLATE(
    "elementary functions of zeros, infinities, NaN and the largest numbers are std's", T, float,
    double, long double) {
  for (const T x : special_numbers<T>()) {
    CAPTURE(x);
    CHECK(agrees(exp(x), std::exp(x)));
    CHECK(agrees(log1p(x), std::log1p(x)));
    CHECK(agrees(acos(x), std::acos(x)));
    CHECK(agrees(asin(x), std::asin(x)));
    if (!(abs(x) > T(1e6) &&
          abs(x) < infinity<T>())) {  // larger ones are angles of half an ulp's doubt
      CHECK(agrees(sin(x), std::sin(x)));
      CHECK(agrees(cos(x), std::cos(x)));
      CHECK(agrees(tan(x), std::tan(x)));
    }
    if (abs(x) < infinity<T>()) CHECK(abs(cos(x)) <= T(1));
    for (const T y : special_numbers<T>()) {
      CAPTURE(y);
      CHECK(agrees(atan2(y, x), std::atan2(y, x)));
      CHECK(agrees(pow(x, y), std::pow(x, y)));
    }
  }
  // Exact where the result is a number that has to come out.
  for (int n = -20; n <= 20; ++n) CHECK(pow(T(2), static_cast<T>(n)) == std::ldexp(T(1), n));
  CHECK(atan2(T(1), T(1)) == pi<T>() / T(4));
  CHECK(tan(T(0)) == T(0));
}

}  // namespace
}  // namespace texmap::test
