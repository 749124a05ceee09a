// Tests of common/number/kinds/double_pair.hpp: its bounds, against numbers of 50 digits.
#include <doctest.h>

#include <algorithm>

#include "number/kinds/judge.hpp"
#include "support/dice.hpp"
#include "support/many_digits.hpp"
#include "support/shown_values.hpp"

namespace texmap::test {
namespace {

using Limits = std::numeric_limits<DoublePair>;

TEST_CASE("a pair keeps what a double loses, and its conversions cut nothing else") {
  const DoublePair more = DoublePair(1) + DoublePair(0x1p-90);
  CHECK(more > DoublePair(1));
  CHECK(more - DoublePair(1) == DoublePair(0x1p-90));
  CHECK(static_cast<double>(more) == 1);
  CHECK(static_cast<int>(DoublePair(3) - DoublePair(1e-20)) == 2);
  CHECK(static_cast<int>(DoublePair(-3) + DoublePair(1e-20)) == -2);
  CHECK(static_cast<int>(DoublePair(3)) == 3);
  CHECK(floor(DoublePair(3) - DoublePair(1e-20)) == DoublePair(2));
  CHECK(floor(DoublePair(-1e-20)) == DoublePair(-1));
  CHECK(floor(DoublePair(0x1p60) + DoublePair(0.75)) == DoublePair(0x1p60));
  // Exact for the 64 bits of x86's long double; ARM64's has 113.
  CHECK(std::abs(static_cast<long double>(DoublePair(0.1L)) - 0.1L) <= 0x1p-108L);
  CHECK(below_one<DoublePair>() < DoublePair(1));
  CHECK(DoublePair(1) + Limits::epsilon() > DoublePair(1));
}

TEST_CASE("comparisons are those of the sum, NaN has none, and infinities stay infinite") {
  const DoublePair nan = Limits::quiet_NaN();
  const DoublePair inf = infinity<DoublePair>();
  const DoublePair less = DoublePair(1) - DoublePair(0x1p-100);
  CHECK((less < DoublePair(1) && DoublePair(1) > less && less != DoublePair(1)));
  CHECK_FALSE((nan < nan || nan >= nan || nan == nan));
  CHECK(abs(-less) == less);
  CHECK(inf + inf == inf);
  CHECK(inf * DoublePair(-2) == -inf);
  CHECK(DoublePair(1) / DoublePair(0) == inf);
  CHECK(DoublePair(1) / inf == DoublePair(0));
  CHECK(sqrt(inf) == inf);
  CHECK(sqrt(DoublePair(0)) == DoublePair(0));
  for (const DoublePair& none : {inf - inf, inf * DoublePair(0), sqrt(DoublePair(-1)), nan + inf})
    CHECK_FALSE(none == none);
  CHECK(exp(DoublePair(-1e9)) == DoublePair(0));
  CHECK(log1p(DoublePair(-1)) == -inf);
}

TEST_CASE("the judge has at least the 64 bits of x86's long double, and says what it is") {
  CHECK(std::numeric_limits<Judge>::digits >= 64);
  CHECK(judge_line().find(judge_is_pair ? "pairs of doubles, 102" : "long double, ") !=
        std::string::npos);
}

#ifdef TEXMAP_HAVE_DIGITS
Digits50 exact(const DoublePair& x) { return Digits50(x.high) + Digits50(x.low); }

/// How far `got` is off, relative to `right` or, where that is smaller, to `unit`.
double off(const DoublePair& got, const Digits50& right, double unit = 0) {
  const Digits50 size = abs(right);
  if (exact(got) == right) return 0;
  if (!got.is_finite()) return 1;
  return static_cast<double>(abs(exact(got) - right) / (size > unit ? size : Digits50(unit)));
}

/// A pair of 10^low to 10^high, of either sign; some are doubles, some have gaps between the parts.
DoublePair drawn(Dice& dice, double low, double high) {
  const double first = dice.any_size(low, high);
  const double second = dice.once_in(4) ? 0 : first * dice.any_size(-24, -16.3);
  return DoublePair::sum(first, second);
}

TEST_CASE("operations and functions are as far off as stated") {
  constexpr int draws = 20000;
  Dice dice(31);
  DoublePair a, b;
  Digits50 x, y;
  const auto check = [&](const char* name, double most, const auto& draw, const auto& error) {
    double worst = 0;
    for (int i = 0; i < draws; ++i) {
      draw();
      x = exact(a);
      y = exact(b);
      worst = std::max(worst, error());
    }
    CHECK_MESSAGE(worst <= most, std::string(name));
  };
  // Of any size; or nearly -a: the sum cancels.
  const auto any = [&] {
    a = drawn(dice, -130, 140);
    b = dice.once_in(2) ? drawn(dice, -130, 140)
                        : a * (DoublePair(-1) + DoublePair(dice.any_size(-30, 0)));
  };
  const auto u = static_cast<double>(unit_roundoff<DoublePair>());
  check("a + b", u, any, [&] { return off(a + b, x + y); });
  check("a - b", u, any, [&] { return off(a - b, x - y); });
  check("a * b", u, any, [&] { return off(a * b, x * y); });
  check("a / b", u, any, [&] { return off(a / b, x / y); });
  check("sqrt", u, any, [&] { return off(sqrt(abs(a)), sqrt(abs(x))); });

  const auto a_place = [&] {
    a = drawn(dice, -60, 60);
    b = dice.once_in(4) ? a * drawn(dice, -20, 20) : drawn(dice, -60, 60);
    if (dice.once_in(16)) (dice.once_in(2) ? a : b) = DoublePair(0);
  };
  const auto sized = [&](double low, double high) {
    return [&, low, high] { a = drawn(dice, low, high); };
  };
  const auto above_minus_one = [&] {
    a = dice.once_in(2) ? abs(drawn(dice, -30, 100)) : -abs(drawn(dice, -30, -0.001));
  };
  const auto per_size = [&](double error) { return error / (1 + std::abs(a.high)); };
  check("atan2", 1e-31, a_place, [&] { return off(atan2(b, a), atan2(y, x)); });
  check("sin", 1e-31, sized(-30, -0.2), [&] { return off(sin(a), sin(x)); });
  check("sin of any size", 1e-31, sized(-30, 6), [&] { return per_size(off(sin(a), sin(x), 1)); });
  check("cos of any size", 1e-31, sized(-30, 6), [&] { return per_size(off(cos(a), cos(x), 1)); });
  check("exp", 1e-31, sized(-30, 2.8), [&] { return per_size(off(exp(a), exp(x))); });
  check("log1p", 1e-30, above_minus_one, [&] { return off(log1p(a), log1p(x), 1); });
  check("acos", 1e-30, sized(-1, 0), [&] { return off(acos(-abs(a)), acos(-abs(x))); });
  check("pow", 1e-28, sized(-1, 0), [&] { return off(pow(a, DoublePair(101)), pow(x, 101)); });
  CHECK(off(pi<DoublePair>(), acos(Digits50(-1))) <= 0x1p-107);
  for (const auto& [dividend, divisor, rest] : {std::array{100000, 360, 280},
                                                {-100000, 360, -280},
                                                {100000, -360, 280},
                                                {-100000, -360, -280},
                                                {-100, 360, -100},
                                                {-720, 360, 0}})
    CHECK(fmod(DoublePair(dividend), DoublePair(divisor)) == DoublePair(rest));
}
#endif

}  // namespace
}  // namespace texmap::test
