// Tests of common/number/kinds/double_pair.hpp: its bounds, against numbers of 50 digits.
#include <doctest.h>

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

/// The largest error of `count` draws.
template <class Error>
double worst(const Error& error, int count = 20000) {
  double largest = 0;
  for (int i = 0; i < count; ++i) largest = std::max(largest, error());
  return largest;
}

TEST_CASE("sums, products, quotients and roots are within one unit roundoff, of any size") {
  Dice dice(31);
  const double u = static_cast<double>(unit_roundoff<DoublePair>());
  DoublePair a, b;
  const auto draw = [&] {
    a = drawn(dice, -130, 140);
    b = dice.once_in(2) ? drawn(dice, -130, 140)  // or nearly -a: the sum cancels
                        : a * (DoublePair(-1) + DoublePair(dice.any_size(-30, 0)));
  };
  CHECK(worst([&] { return draw(), off(a + b, exact(a) + exact(b)); }) <= u);
  CHECK(worst([&] { return draw(), off(a - b, exact(a) - exact(b)); }) <= u);
  CHECK(worst([&] { return draw(), off(a * b, exact(a) * exact(b)); }) <= u);
  CHECK(worst([&] { return draw(), off(a / b, exact(a) / exact(b)); }) <= u);
  CHECK(worst([&] { return draw(), off(sqrt(abs(a)), sqrt(exact(abs(a)))); }) <= u);
}

TEST_CASE("functions are as far off as stated") {
  Dice dice(47);
  const Digits50 turn = 2 * acos(Digits50(-1));
  CHECK(off(pi<DoublePair>(), turn / 2) <= 0x1p-107);
  DoublePair x, y;
  const auto angle = [&] {
    x = drawn(dice, -60, 60);
    y = dice.once_in(4) ? x * drawn(dice, -20, 20) : drawn(dice, -60, 60);
    if (dice.once_in(16)) (dice.once_in(2) ? x : y) = DoublePair(0);
    return off(atan2(y, x), atan2(exact(y), exact(x)));
  };
  CHECK(worst(angle) <= 1e-31);
  CHECK(worst([&] { return x = drawn(dice, -30, -0.2), off(sin(x), sin(exact(x))); }) <= 1e-31);
  const auto of_any_size = [&](const auto& function, const auto& right) {
    return worst([&] {
      x = drawn(dice, -30, 6);
      return off(function(x), right(exact(x)), 1) / (1 + std::abs(x.high));
    });
  };
  CHECK(of_any_size([](auto& a) { return sin(a); }, [](const Digits50& a) { return sin(a); }) <=
        1e-31);
  CHECK(of_any_size([](auto& a) { return cos(a); }, [](const Digits50& a) { return cos(a); }) <=
        1e-31);
  const auto powers = [&] {
    x = drawn(dice, -30, 2.8);
    return off(exp(x), exp(exact(x))) / (1 + std::abs(x.high));
  };
  CHECK(worst(powers) <= 1e-31);
  const auto logs = [&] {
    x = dice.once_in(2) ? abs(drawn(dice, -30, 100)) : -abs(drawn(dice, -30, -0.001));
    return off(log1p(x), log1p(exact(x)), 1);
  };
  CHECK(worst(logs) <= 1e-30);
  x = drawn(dice, -1, 0);
  CHECK(off(pow(x, DoublePair(101)), pow(exact(x), 101)) <= 1e-28);
  CHECK(off(acos(-abs(x)), acos(-exact(abs(x)))) <= 1e-30);
  CHECK(off(fmod(DoublePair(100000), DoublePair(360)), Digits50(280)) == 0);
  CHECK(off(fmod(DoublePair(-100000), DoublePair(360)), Digits50(-280)) == 0);
  CHECK(off(fmod(DoublePair(100000), DoublePair(-360)), Digits50(280)) == 0);
  CHECK(off(fmod(DoublePair(-100000), DoublePair(-360)), Digits50(-280)) == 0);
  CHECK(off(fmod(DoublePair(-100), DoublePair(360)), Digits50(-100)) == 0);
  CHECK(fmod(DoublePair(-720), DoublePair(360)).high == 0);
}
#endif

}  // namespace
}  // namespace texmap::test
