// Tests of common/number/kinds/interval.hpp: what an interval promises holds for numbers of all
// sizes, and its bounds are close.
#include <doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>

#include "number/kinds/interval.hpp"
#include "number/operations.hpp"
#include "number/table.hpp"
#include "support/dice.hpp"
#include "support/many_digits.hpp"

#ifdef TEXMAP_HAVE_DIGITS
#define TEXMAP_JUDGES double, long double, Digits50
#else
#define TEXMAP_JUDGES double, long double
#endif

namespace texmap::test {
namespace {

using Limits = std::numeric_limits<double>;
constexpr double inf = Limits::infinity();
constexpr double tiny = Limits::denorm_min();
constexpr double huge = Limits::max();
constexpr Interval anything = Interval::anything();

constexpr Tribool yes{.can_be_true = true, .can_be_false = false};
constexpr Tribool no{.can_be_true = false, .can_be_false = true};
constexpr Tribool unknown{.can_be_true = true, .can_be_false = true};

bool same(const Interval& a, const Interval& b) {
  return a.low() == b.low() && a.high() == b.high();
}
bool same(const Tribool& a, const Tribool& b) {
  return a.can_be_true == b.can_be_true && a.can_be_false == b.can_be_false;
}

/// The number's place among all doubles: neighbours are 1 apart, both zeros are 0.
std::int64_t place(double x) {
  const auto size = std::bit_cast<std::int64_t>(std::abs(x));
  return std::signbit(x) ? -size : size;
}
double at_place(std::int64_t place) {
  return place < 0 ? -std::bit_cast<double>(-place) : std::bit_cast<double>(place);
}
/// How many steps from number to number an interval reaches beyond two numbers, at most.
std::int64_t beyond(const Interval& a, double low, double high) {
  return std::max(place(low) - place(a.low()), place(a.high()) - place(high));
}

/// A number of any size, often near 1, often where arithmetic tends to go wrong.
double draw_number(Dice& dice) {
  static constexpr double corners[] = {0,   -0.0, tiny, -tiny, Limits::min(), 1,   -1,
                                       0.5, 3,    huge, -huge, inf,           -inf};
  const int kind = dice.below(10);
  if (kind == 0) return corners[dice.below(13)];
  if (kind < 6) return dice.sign() * dice.number<double>(-4, 5);
  if (kind < 8) return dice.finite<double>();
  return dice.sign() *
         (kind == 8 ? dice.number<double>(-1074, -1014) : dice.number<double>(964, 1024));
}
double draw_finite(Dice& dice) {
  double x = draw_number(dice);
  while (std::isinf(x)) x = draw_number(dice);
  return x;
}
/// A single number, some neighbours, or any two ends.
Interval draw_interval(Dice& dice, double (*draw)(Dice&)) {
  const double a = draw(dice);
  double b = draw(dice);
  const int kind = dice.below(4);
  if (kind == 0) b = a;
  if (kind == 1) b = at_place(std::min(place(a) + dice.below(1000), place(huge)));
  return {std::min(a, b), std::max(a, b)};
}
/// A number in the interval, often one of its ends.
double draw_in(Dice& dice, const Interval& a) {
  const int kind = dice.below(6);
  if (kind == 0) return a.low();
  if (kind == 1) return a.high();
  if (kind == 2 && a.contains(0.0)) return dice.once_in(2) ? 0.0 : -0.0;
  const auto low = static_cast<std::uint64_t>(place(a.low()));
  const std::uint64_t width = static_cast<std::uint64_t>(place(a.high())) - low;
  return at_place(static_cast<std::int64_t>(low + dice.bits() % (width + 1)));
}

constexpr int trials = 200000;

/// Whether a number of any kind lies in an interval; a NaN lies only in the whole line.
template <class Number>
bool holds(const Interval& bounds, const Number& number) {
  if constexpr (std::is_floating_point_v<Number>) {
    return bounds.contains(number);
  } else {
    return Number(bounds.low()) <= number && number <= Number(bounds.high());
  }
}

/// Checks that what an operation gives for numbers lies in what it gives for intervals around them.
template <class Number>
void check_enclosure(const std::string& name, const auto& operation, int count) {
  constexpr bool has_infinity = std::is_floating_point_v<Number>;
  Dice dice;
  long wrong = 0;
  for (int i = 0; i < count; ++i) {
    const Interval a = draw_interval(dice, draw_number);
    const Interval b = draw_interval(dice, draw_number);
    const double x = draw_in(dice, a);
    const double y = draw_in(dice, b);
    // Beyond what double holds, the functions of 50 digits are slow.
    if (!has_infinity && !(std::isfinite(x) && std::isfinite(y) && std::isfinite(operation(x, y)) &&
                           std::abs(x) < 1e300 && (x != 0 || y != 0)))
      continue;
    const Interval bounds = operation(a, b);
    const Number result = operation(Number(x), Number(y));
    if (holds(bounds, result) && bounds.low() <= bounds.high()) continue;
    if (++wrong > 1) continue;
    INFO("[" << a.low() << ", " << a.high() << "] and [" << b.low() << ", " << b.high()
             << "] give [" << bounds.low() << ", " << bounds.high() << "], at " << x << " and "
             << y);
    FAIL_CHECK(name);
  }
  CHECK(wrong == 0);
}

TEST_CASE_TEMPLATE(
    "what numbers give lies in what intervals around them give, NaN in the whole line", Number,
    TEXMAP_JUDGES) {
  constexpr bool quick = std::is_floating_point_v<Number>;
  const auto check = [](const std::string& name, const auto& operation) {
    check_enclosure<Number>(name, operation, quick ? trials : trials / 4);
  };
  for_each_arithmetic(check);
  for_each_choice(check);
  for_each_function([](const std::string& name, const auto& function) {
    check_enclosure<Number>(name, function, quick ? trials : trials / 40);
  });
  // A NaN on the way gives bounds again only by comparing.
  check("max of a root", [](auto a, auto b) { return max(b, sqrt(a)); });
  check("min of a quotient", [](auto a, auto b) { return min(b, a / b); });
  check("a / b <= inf", [](auto a, auto b) { return select(a / b <= decltype(a)(inf), a, b); });
}

TEST_CASE("bounds reach one number beyond what the intervals' ends give, functions' bounds four") {
  const auto check = [](const std::string& name, const auto& operation, int most) {
    CAPTURE(name);
    Dice dice;
    std::int64_t worst = 0;
    for (int i = 0; i < trials; ++i) {
      const Interval a = draw_interval(dice, draw_finite);
      const Interval b = draw_interval(dice, draw_finite);
      const Interval bounds = operation(a, b);
      double low = inf;
      double high = -inf;
      bool defined = true;
      // Every operation is greatest and least at ends, or where a sign changes.
      for (const double x : {a.low(), a.high(), clamp(0.0, a.low(), a.high())}) {
        for (const double y : {b.low(), b.high(), clamp(0.0, b.low(), b.high())}) {
          const double result = operation(x, y);
          defined = defined && std::isfinite(result);
          low = std::min(low, result);
          high = std::max(high, result);
        }
      }
      // Where something is undefined, or the angle jumps, there is more between the ends.
      if (!defined || (most == 4 && bounds.high() - bounds.low() > 6.28)) continue;
      worst = std::max(worst, beyond(bounds, low, high));
    }
    CHECK(worst == most);
  };
  for_each_arithmetic([&](const std::string& name, const auto& operation) {
    const bool exact = name == "-a" || name == "abs" || name == "floor" || name == "max" ||
                       name == "min" || name == "clamp";
    check(name, operation, exact ? 0 : 1);
  });
  for_each_function(
      [&](const std::string& name, const auto& function) { check(name, function, 4); });
  for (const double exponent : {0.5, 1.0, 2.0, 2.5, 3.0, 50.0}) {
    check(
        "power", [exponent](auto a, auto) { return power(a, exponent); }, 4);
  }
}

TEST_CASE("powers of numbers lie in the powers of intervals around them") {
  for (const double exponent : {0.0, 1.0, 2.0, 3.0, 10.0, 51.0, 50.0, 0.5, 2.5, -1.0, -2.0, -0.5}) {
    CAPTURE(exponent);
    check_enclosure<double>(
        "power", [exponent](auto a, auto) { return power(a, exponent); }, trials);
  }
  CHECK(Interval(std::numeric_limits<long double>::quiet_NaN()).is_anything());
  // A large exponent multiplies the error of the logarithm.
  CHECK(power(Interval(1.4094529222100427), 2005.5053497610104)
            .contains(static_cast<double>(8.35072729589207458e298L)));
  CHECK(same(power(Interval(-1, 2), 0.5), anything));
  CHECK(same(power(Interval(-1, 2), -1), anything));
  CHECK(power(Interval(2, 4), -1).low() > 0.25 - 1e-15);  // rounded once more
  CHECK(power(Interval(2, 4), -1).high() < 0.5 + 1e-15);
}

TEST_CASE("comparisons are certain where intervals are apart, or share what decides") {
  CHECK((same(Interval(1, 2) < Interval(3, 4), yes) && same(Interval(3, 4) < Interval(1, 2), no)));
  CHECK((same(Interval(1, 2) == Interval(3), no) && same(Interval(3) > Interval(1, 2), yes)));
  CHECK(same(Interval(1, 2) < Interval(2, 3), unknown));
  CHECK(same(Interval(1, 2) <= Interval(2, 3), yes));
  CHECK(same(Interval(2, 3) >= Interval(1, 2), yes));
  CHECK(same(Interval(2) == Interval(2), yes));
  CHECK(same(Interval(0.0) == Interval(-0.0), yes));
  CHECK(same(Interval(1, 2) == Interval(1, 2), unknown));
  // The whole line may be NaN, which no comparison finds true.
  CHECK(same(anything <= Interval(inf), unknown));
  CHECK(same(Interval(-inf) <= anything, unknown));
}

TEST_CASE("masks and what they choose: the certain side, or the hull of both") {
  CHECK((same(!yes, no) && same(!no, yes) && same(!unknown, unknown)));
  CHECK((same(yes && yes, yes) && same(no && unknown, no) && same(unknown && no, no)));
  CHECK((same(yes && unknown, unknown) && same(unknown && unknown, unknown)));
  CHECK((same(no || no, no) && same(yes || unknown, yes) && same(unknown || yes, yes)));
  CHECK((same(no || unknown, unknown) && same(unknown || unknown, unknown)));
  CHECK((any(yes) && any(unknown) && !any(no)));
  CHECK(same(select(yes, Interval(1, 2), anything), Interval(1, 2)));
  CHECK(same(select(no, anything, Interval(1, 2)), Interval(1, 2)));
  CHECK(same(select(unknown, Interval(1, 2), Interval(5)), Interval(1, 5)));
  CHECK(same(select(unknown, Interval(1), anything), anything));
  CHECK(same(clamp(anything, Interval(0), Interval(1)), Interval(0, 1)));
}

TEST_CASE("a product, quotient or power does not lose its sign to the widening") {
  Dice dice;
  long lost = 0;
  for (int i = 0; i < trials; ++i) {
    const Interval a = abs(draw_interval(dice, draw_finite));
    const Interval b = abs(draw_interval(dice, draw_finite));
    lost += power(a, 2.5).low() >= 0 && power(-a, 2).low() >= 0 ? 0 : 1;
    lost += (a * b).low() >= 0 && (-a * b).high() <= 0 && (-a * -b).low() >= 0 ? 0 : 1;
    if (b.low() > 0)
      lost += (a / b).low() >= 0 && (-a / b).high() <= 0 && (a / -b).high() <= 0 ? 0 : 1;
  }
  CHECK(lost == 0);
  CHECK(same(Interval(0) * Interval(-3, 5), Interval(0)));
  CHECK(same(Interval(0) / Interval(3, 5), Interval(0)));
  CHECK(square(Interval(-tiny, tiny)).low() == 0);
}

TEST_CASE("arithmetic with whole numbers and powers of two is exact, and infinity stays infinity") {
  for (int i = -1000; i <= 1000; i += 7) {
    const Interval x(i);
    CHECK(same(x + Interval(999), Interval(i + 999)));
    CHECK(same(x - Interval(0.25), Interval(i - 0.25)));
    CHECK(same(x * Interval(0.5), Interval(i * 0.5)));
    CHECK(same(Interval(-4) * x, Interval(-4 * i)));
    CHECK(same(x / Interval(2), Interval(i * 0.5)));
  }
  CHECK(same(sqrt(Interval(0, 1)), Interval(0, 1)));
  CHECK(sqrt(Interval(1 - 0x1p-53)).high() == 1);  // 1 - 2^-54 is no double
  // Not where digits drop off the end of the range.
  CHECK((Interval(3 * tiny) * Interval(0.5)).contains(1.5L * static_cast<long double>(tiny)));
  CHECK_FALSE((Interval(3 * tiny) * Interval(0.5)).is_point());
  CHECK((Interval(2 - 0x1p-52) * Interval(0x1p-1023)).low() < 0x1p-1022);  // less by half of tiny
  CHECK(same(Interval(huge) * Interval(2), Interval(huge, inf)));
  CHECK(same(Interval(huge) + Interval(huge), Interval(huge, inf)));
  CHECK(same(Interval(inf) + Interval(5), Interval(inf)));
  CHECK(same(Interval(inf) * Interval(-3, -0.1), Interval(-inf)));
  CHECK(same(Interval(inf) / Interval(0.3), Interval(inf)));
  CHECK(same(Interval(0.3) / Interval(inf), Interval(0)));
  CHECK(same(Interval(-1, inf) * Interval(2), Interval(-2, inf)));
}

TEST_CASE("a box beside the jump of the angle keeps its own bounds") {
  CHECK(atan2(Interval(tiny, 1), Interval(-1)).high() == pi<Interval>().high());
  CHECK(atan2(Interval(tiny, 1), Interval(-1)).low() == doctest::Approx(pi<double>() * 3 / 4));
}

TEST_CASE("constants hold the real ones; what double cannot show lies between its neighbours") {
  CHECK(pi<Interval>().contains(std::numbers::pi_v<long double>));
  CHECK_FALSE(pi<Interval>().contains(std::nextafter(std::numbers::pi, 0)));
  CHECK(beyond(pi<Interval>(), std::numbers::pi, std::numbers::pi) == 1);
  CHECK(below_one<Interval>().contains(below_one<double>()));
  CHECK(below_one<Interval>().contains(below_one<long double>()));
  CHECK(same(infinity<Interval>(), Interval(inf)));
  CHECK(same(unit_roundoff<Interval>(), Interval(unit_roundoff<double>())));
  CHECK(same(Interval(0.1), Interval(0.1, 0.1)));
  CHECK(Interval(0.1L).contains(0.1L));
  CHECK(beyond(Interval(0.1L), 0.1, 0.1) ==
        (Limits::digits == std::numeric_limits<long double>::digits ? 0 : 1));
  CHECK(same(Interval(0.5L), Interval(0.5)));
  CHECK(same(Interval(std::int64_t{1} << 53), Interval(0x1p53)));
  const Interval odd((std::int64_t{1} << 53) + 1);
  CHECK((odd.low() == 0x1p53 - 1 || odd.low() == 0x1p53));
  CHECK(odd.high() >= 0x1p53 + 2);
}

TEST_CASE("a table looked up at an uncertain place gives the hull of all entries there") {
  const auto table = [](int column, int row) {
    return std::array{10 * row + column, 7, (column - 5) * (column - 5)};
  };
  const auto box = look_up(table, Interval(2, 4), Interval(1, 3));
  CHECK(same(look_up(table, Interval(2), Interval(3))[0], Interval(32)));
  CHECK(same(box[0], Interval(12, 34)));
  CHECK(same(box[1], Interval(7)));
  CHECK(same(look_up(table, Interval(3, 9), Interval(0))[2], Interval(0, 16)));
  CHECK(look_up(table, 2.0, 3.0)[0] == 32);
}

TEST_CASE("sums and products in two parts hold those of double, part by part") {
  Dice dice;
  long outside = 0;
  for (int i = 0; i < trials; ++i) {
    const double x = dice.any_size(-100, 100);
    const double y = dice.any_size(-100, 100);
    const Interval around_x(x, at_place(place(x) + i % 3));
    const Interval around_y(at_place(place(y) - i % 5), y);
    const auto judge = [&](const TwoParts<Interval>& bounds, const TwoParts<double>& parts) {
      outside += bounds.high.contains(parts.high) && bounds.low.contains(parts.low) ? 0 : 1;
    };
    judge(two_sum(around_x, around_y), two_sum(x, y));
    judge(two_product(around_x, around_y), two_product(x, y));
  }
  CHECK(outside == 0);
  CHECK(same(two_sum(Interval(1), Interval(2)).low, Interval(0)));
}

TEST_CASE("the scale of an interval is one power of two that brings its upper end near 1") {
  for (const double size : {1.0, 0.7, 3.0, 1e300, huge, Limits::min(), 1e-310})
    CHECK(same(power_of_two_scale(Interval(size / 2, size)), Interval(power_of_two_scale(size))));
  CHECK(same(power_of_two_scale(Interval(0)), Interval(1)));
  CHECK(same(power_of_two_scale(anything), Interval(1)));
}

}  // namespace
}  // namespace texmap::test
