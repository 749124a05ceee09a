// Tests of common/number/kinds/interval.hpp: what an interval promises holds for numbers of all
// sizes, and its bounds are close.
#include <doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "number/kinds/interval.hpp"
#include "support/many_digits.hpp"

#if defined(TEXMAP_HAVE_DIGITS) && __has_include(<boost/numeric/interval.hpp>)
#define TEXMAP_HAVE_BOOST
#include <boost/numeric/interval.hpp>
#endif

namespace texmap::test {
namespace {

using Limits = std::numeric_limits<double>;
constexpr double inf = Limits::infinity();
constexpr double nan = Limits::quiet_NaN();
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
bool can_be(const Tribool& mask, bool truth) {
  return truth ? mask.can_be_true : mask.can_be_false;
}

/// The number's place among all doubles: neighbours are 1 apart, both zeros are 0.
std::int64_t place(double x) {
  const auto size = std::bit_cast<std::int64_t>(std::abs(x));
  return std::signbit(x) ? -size : size;
}
double at_place(std::int64_t place) {
  return place < 0 ? -std::bit_cast<double>(-place) : std::bit_cast<double>(place);
}
/// How many steps from number to number the bounds are apart.
std::int64_t steps(const Interval& a) { return place(a.high()) - place(a.low()); }

/// Numbers of every size, and often those where arithmetic tends to go wrong.
class Random {
 public:
  double next() {
    static constexpr double corners[] = {0,   -0.0, tiny, -tiny, Limits::min(), 1,   -1,
                                         0.5, 3,    huge, -huge, inf,           -inf};
    const auto kind = below(10);
    if (kind == 0) return corners[below(std::size(corners))];
    const double size =
        std::ldexp(1 + static_cast<double>(random_() >> 11U) * 0x1p-53, exponent(kind));
    return below(2) == 0 ? size : -size;
  }
  double next_finite() {
    double x = next();
    while (std::isinf(x)) x = next();
    return x;
  }
  /// A single number, some neighbours, or any two ends.
  Interval interval(bool finite = false) {
    const double a = finite ? next_finite() : next();
    const auto kind = below(4);
    double b = finite ? next_finite() : next();
    if (kind == 0) b = a;
    if (kind == 1)
      b = at_place(
          std::min(place(a) + static_cast<std::int64_t>(below(1000)), place(finite ? huge : inf)));
    return {std::min(a, b), std::max(a, b)};
  }
  /// A number in the interval, often one of its ends.
  double in(const Interval& a) {
    const auto kind = below(6);
    if (kind == 0) return a.low();
    if (kind == 1) return a.high();
    if (kind == 2 && a.contains(0.0)) return below(2) == 0 ? 0.0 : -0.0;
    const auto low = place(a.low());
    const std::uint64_t width =
        static_cast<std::uint64_t>(place(a.high())) - static_cast<std::uint64_t>(low);
    return at_place(
        static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + random_() % (width + 1)));
  }

 private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
  int exponent(std::size_t kind) {
    if (kind < 6) return static_cast<int>(below(9)) - 4;        // near 1
    if (kind < 8) return static_cast<int>(below(2098)) - 1074;  // anywhere
    return kind == 8 ? static_cast<int>(below(60)) - 1074 : static_cast<int>(below(60)) + 964;
  }

  std::mt19937_64 random_{20240229};
};

constexpr int trials = 200000;

template <class Number>
bool holds(const Interval& bounds, const Number& number) {
  if constexpr (std::is_floating_point_v<Number>) {
    return bounds.contains(number);
  } else {
    return Number(bounds.low()) <= number && number <= Number(bounds.high());
  }
}

// The law, tested with the number itself: double's result is inside; NaN only in the whole line.

/// How many results of an operation on numbers lie outside its result on intervals.
///
/// @tparam Number    of the reference: a NaN lies only in the whole line
/// @param in_domain  says which pairs of numbers have a result
template <class Number, class Operation, class InDomain>
long outside(const Operation& operation, int count, const InDomain& in_domain) {
  Random random;
  long found = 0;
  while (count > 0) {
    const Interval a = random.interval();
    const Interval b = random.interval();
    const double x = random.in(a);
    const double y = random.in(b);
    if (!in_domain(x, y)) continue;
    --count;
    const Interval bounds = operation(a, b);
    const Number result = operation(Number(x), Number(y));
    if (!(holds(bounds, result) && bounds.low() <= bounds.high()) && ++found == 1) {
      MESSAGE("first: [" << a.low() << ", " << a.high() << "] and [" << b.low() << ", " << b.high()
                         << "] give [" << bounds.low() << ", " << bounds.high() << "] at " << x
                         << " and " << y);
    }
  }
  return found;
}
template <class Number, class Operation>
long outside(const Operation& operation) {
  return outside<Number>(operation, trials, [](double, double) { return true; });
}

TEST_CASE_TEMPLATE(
    "what numbers give lies in what intervals around them give, and NaN only in the whole line",
    Number, double, long double) {
  CHECK(outside<Number>([](auto a, auto b) { return a + b; }) == 0);
  CHECK(outside<Number>([](auto a, auto b) { return a - b; }) == 0);
  CHECK(outside<Number>([](auto a, auto b) { return a * b; }) == 0);
  CHECK(outside<Number>([](auto a, auto b) { return a / b; }) == 0);
  CHECK(outside<Number>([](auto a, auto) { return -a; }) == 0);
  CHECK(outside<Number>([](auto a, auto) { return abs(a); }) == 0);
  CHECK(outside<Number>([](auto a, auto) { return floor(a); }) == 0);
  CHECK(outside<Number>([](auto a, auto) { return square(a); }) == 0);
  CHECK(outside<Number>([](auto a, auto) { return sqrt(a); }) == 0);
  CHECK(outside<Number>([](auto a, auto) { return exp(a); }) == 0);
  CHECK(outside<Number>([](auto a, auto) { return log1p(a); }) == 0);
  CHECK(outside<Number>([](auto a, auto b) { return atan2(a, b); }) == 0);
  CHECK(outside<Number>([](auto a, auto b) { return max(a, b); }) == 0);
  CHECK(outside<Number>([](auto a, auto b) { return min(a, b); }) == 0);
  CHECK(outside<Number>([](auto a, auto b) { return clamp(a, decltype(a)(-1), abs(b)); }) == 0);
  CHECK(outside<Number>([](auto a, auto b) { return select(a < b, a, b); }) == 0);
  // A NaN on the way gives bounds again only by comparing.
  CHECK(outside<Number>([](auto a, auto b) { return max(b, sqrt(a)); }) == 0);
  CHECK(outside<Number>([](auto a, auto b) { return min(b, a / b); }) == 0);
  CHECK(outside<Number>([](auto a, auto b) { return select(a / b <= decltype(a)(inf), a, b); }) ==
        0);
}

TEST_CASE("powers of numbers lie in the powers of intervals around them") {
  for (const double exponent : {0.0, 1.0, 2.0, 3.0, 10.0, 51.0, 50.0, 0.5, 2.5, -1.0, -2.0, -0.5}) {
    CAPTURE(exponent);
    CHECK(outside<double>([exponent](auto a, auto) { return power(a, exponent); }) == 0);
  }
  CHECK(same(power(Interval(-1, 2), 2), power(Interval(0, 2), 2)));
  CHECK(same(power(Interval(-1, 2), 0.5), anything));
  CHECK(same(power(Interval(-1, 2), -1), anything));
}

TEST_CASE(
    "comparisons say what can be true and what can be false, and are certain where the intervals "
    "are apart") {
  Random random;
  long wrong = 0;
  long hesitant = 0;
  for (int i = 0; i < trials; ++i) {
    const Interval a = random.interval();
    const Interval b = random.interval();
    const double x = random.in(a);
    const double y = random.in(b);
    wrong += can_be(a < b, x < y) && can_be(a <= b, x <= y) && can_be(a > b, x > y) &&
                     can_be(a >= b, x >= y)
                 ? 0
                 : 1;
    wrong += can_be(a == b, x == y) && can_be(!(a < b) && a > b, !(x < y) && x > y) ? 0 : 1;
    if (a.high() < b.low())
      hesitant +=
          same(a < b, yes) && same(a <= b, yes) && same(b < a, no) && same(a == b, no) ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(hesitant == 0);
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

TEST_CASE("masks follow the truth tables of what can be") {
  for (const Tribool& a : {yes, no, unknown}) {
    for (const Tribool& b : {yes, no, unknown}) {
      Tribool negated{false, false};
      Tribool both{false, false};
      Tribool either{false, false};
      // Try every truth that the two can have.
      for (const bool x : {false, true}) {
        if (!can_be(a, x)) continue;
        (!x ? negated.can_be_true : negated.can_be_false) = true;
        for (const bool y : {false, true}) {
          if (!can_be(b, y)) continue;
          (x && y ? both.can_be_true : both.can_be_false) = true;
          (x || y ? either.can_be_true : either.can_be_false) = true;
        }
      }
      CHECK(same(!a, negated));
      CHECK(same(a && b, both));
      CHECK(same(a || b, either));
    }
  }
  CHECK(any(yes));
  CHECK(any(unknown));
  CHECK_FALSE(any(no));
}

TEST_CASE("select gives the certain side, or the hull of both; max and min are closer") {
  CHECK(same(select(yes, Interval(1, 2), anything), Interval(1, 2)));
  CHECK(same(select(no, anything, Interval(1, 2)), Interval(1, 2)));
  CHECK(same(select(unknown, Interval(1, 2), Interval(5)), Interval(1, 5)));
  CHECK(same(select(unknown, Interval(1), anything), anything));
  CHECK(same(max(Interval(1, 4), Interval(2, 3)), Interval(2, 4)));
  CHECK(same(min(Interval(1, 4), Interval(2, 3)), Interval(1, 3)));
  CHECK(same(clamp(anything, Interval(0), Interval(1)), Interval(0, 1)));
}

TEST_CASE("a square is never negative, where a product of two intervals may be") {
  CHECK(square(Interval(-1, 2)).low() == 0);
  CHECK(square(Interval(-1, 2)).high() == doctest::Approx(4));
  CHECK((Interval(-1, 2) * Interval(-1, 2)).low() == doctest::Approx(-2));
  CHECK(square(Interval(-tiny, tiny)).low() == 0);
}

TEST_CASE("a product or quotient does not lose its sign to the widening") {
  Random random;
  long lost = 0;
  for (int i = 0; i < trials; ++i) {
    const Interval a = abs(random.interval(true));
    const Interval b = abs(random.interval(true));
    lost += (a * b).low() >= 0 && (-a * b).high() <= 0 && (-a * -b).low() >= 0 ? 0 : 1;
    if (b.low() > 0)
      lost += (a / b).low() >= 0 && (-a / b).high() <= 0 && (a / -b).high() <= 0 ? 0 : 1;
  }
  CHECK(lost == 0);
  CHECK(same(Interval(0) * Interval(-3, 5), Interval(0)));
  CHECK(same(Interval(0) / Interval(3, 5), Interval(0)));
}

TEST_CASE("arithmetic with whole numbers and powers of two is exact") {
  for (int i = -1000; i <= 1000; i += 7) {
    const Interval x(i);
    CHECK(same(x + Interval(999), Interval(i + 999)));
    CHECK(same(x - Interval(0.25), Interval(i - 0.25)));
    CHECK(same(x * Interval(0.5), Interval(i * 0.5)));
    CHECK(same(Interval(-4) * x, Interval(-4 * i)));
    CHECK(same(x / Interval(2), Interval(i * 0.5)));
    CHECK(same(floor(x * Interval(0.5)), Interval(std::floor(i * 0.5))));
  }
  CHECK(same(sqrt(Interval(0, 1)), Interval(0, 1)));
  // Not where digits drop off the end of the range.
  CHECK((Interval(3 * tiny) * Interval(0.5)).contains(1.5L * static_cast<long double>(tiny)));
  CHECK_FALSE((Interval(3 * tiny) * Interval(0.5)).is_point());
  CHECK(same(Interval(huge) * Interval(2), Interval(huge, inf)));
  CHECK(same(Interval(huge) + Interval(huge), Interval(huge, inf)));
}

TEST_CASE("infinity stays infinity") {
  CHECK(same(Interval(inf) + Interval(5), Interval(inf)));
  CHECK(same(Interval(inf) * Interval(-3, -0.1), Interval(-inf)));
  CHECK(same(Interval(inf) / Interval(0.3), Interval(inf)));
  CHECK(same(Interval(0.3) / Interval(inf), Interval(0)));
  CHECK(same(Interval(-1, inf) * Interval(2), Interval(-2, inf)));
}

TEST_CASE("what is undefined gives the whole line") {
  CHECK(same(Interval(0) * Interval(inf), anything));
  CHECK(same(Interval(0, 1) * Interval(5, inf), anything));
  CHECK(same(Interval(inf) - Interval(inf), anything));
  CHECK(same(Interval(inf) / Interval(1, inf), anything));
  CHECK(same(Interval(0) / Interval(0), anything));
  CHECK(same(Interval(1) / Interval(-1, 1), anything));
  CHECK(same(Interval(1) / Interval(0, 1), anything));
  CHECK(same(sqrt(Interval(-tiny, 4)), anything));
  CHECK(same(log1p(Interval(-2, 4)), anything));
  CHECK(same(Interval(nan), anything));
  for (const Interval& result :
       {abs(anything), square(anything), exp(anything), floor(anything), -anything,
        anything + Interval(1), atan2(anything, Interval(1)), atan2(Interval(1), anything)})
    CHECK(same(result, anything));
}

TEST_CASE("a box that touches the negative x axis or the origin has every angle") {
  for (const auto& [y, x] :
       {std::pair(Interval(-1, 1), Interval(-2, -1)), std::pair(Interval(0, 1), Interval(-2, -1)),
        std::pair(Interval(-1, 0), Interval(-2, -1)), std::pair(Interval(0), Interval(-1)),
        std::pair(Interval(0), Interval(0)), std::pair(Interval(-1, 1), Interval(-1, 1)),
        std::pair(Interval(0, 1), Interval(0, 1)), std::pair(Interval(-1, 1), Interval(0, 3))}) {
    const Interval angle = atan2(y, x);
    CHECK(angle.low() == -pi<Interval>().high());
    CHECK(angle.high() == pi<Interval>().high());
  }
}

TEST_CASE("a box near the jump has the angles between two of its corners") {
  const auto between = [](const Interval& y, const Interval& x, double low, double high) {
    const Interval angle = atan2(y, x);
    CHECK(angle.low() == doctest::Approx(low));
    CHECK(angle.high() == doctest::Approx(high));
  };
  const double turn = std::numbers::pi * 2;
  between({1, 1}, {-1, 1}, turn / 8, turn * 3 / 8);
  between({1, 2}, {1, 2}, std::atan2(1, 2), std::atan2(2, 1));
  between({1, 2}, {-2, -1}, std::atan2(2, -1), std::atan2(1, -2));
  between({-2, -1}, {-2, -1}, std::atan2(-1, -2), std::atan2(-2, -1));
  between({-2, -1}, {1, 2}, std::atan2(-2, 1), std::atan2(-1, 2));
  between({-1, 1}, {1, 2}, -turn / 8, turn / 8);
  between({tiny, 1}, {-1, -1}, turn * 3 / 8, turn / 2);
  CHECK(atan2(Interval(tiny, 1), Interval(-1)).high() == pi<Interval>().high());
  CHECK(atan2(Interval(tiny, 1), Interval(-1)).low() > 0);
}

TEST_CASE(
    "the constants hold the real ones, and a number that double cannot show lies between its "
    "neighbours") {
  CHECK(pi<Interval>().contains(std::numbers::pi_v<long double>));
  CHECK_FALSE(pi<Interval>().contains(std::nextafter(std::numbers::pi, 0)));
  CHECK(steps(pi<Interval>()) == 1);
  CHECK(below_one<Interval>().contains(below_one<double>()));
  CHECK(below_one<Interval>().contains(below_one<long double>()));
  CHECK(same(infinity<Interval>(), Interval(inf)));
  CHECK(same(unit_roundoff<Interval>(), Interval(unit_roundoff<double>())));
  CHECK(same(Interval(0.1), Interval(0.1, 0.1)));
  CHECK(Interval(0.1L).contains(0.1L));
  CHECK(steps(Interval(0.1L)) ==
        (Limits::digits == std::numeric_limits<long double>::digits ? 0 : 2));
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
  const auto point = look_up(table, Interval(2), Interval(3));
  CHECK(same(point[0], Interval(32)));
  CHECK(same(point[1], Interval(7)));
  const auto box = look_up(table, Interval(2, 4), Interval(1, 3));
  CHECK(same(box[0], Interval(12, 34)));
  CHECK(same(box[1], Interval(7)));
  CHECK(same(look_up(table, Interval(3, 9), Interval(0))[2], Interval(0, 16)));
  CHECK(look_up(table, 2.0, 3.0)[0] == 32);
}

TEST_CASE("the powers of an interval reach no farther than they must") {
  // At most four steps beyond each end, and never below zero where the numbers are not.
  const auto tight = [](const Interval& got, double low, double high) {
    const auto below = place(low) - place(got.low());
    const auto above = place(got.high()) - place(high);
    return below >= 0 && below <= 4 && above >= 0 && above <= 4;
  };
  CHECK(tight(power(Interval(0.25, 4), 0.5), 0.5, 2));
  CHECK(tight(power(Interval(0.25, 0.75), 2), 0.0625, 0.5625));
  CHECK(tight(power(Interval(4, 9), 1.5), 8, 27));
  CHECK(tight(power(Interval(-2, 3), 3), -8, 27));
  CHECK(tight(power(Interval(-3, -2), 3), -27, -8));
  CHECK(tight(power(Interval(-3, -2), 2), 4, 9));
  CHECK(tight(power(Interval(2, 3), 1), 2, 3));
  for (const double exponent : {0.5, 1.0, 2.0, 2.5, 50.0}) {
    const Interval from_zero = power(Interval(0, 1), exponent);
    CHECK(from_zero.low() == 0);
    CHECK(tight(from_zero, 0, 1));
  }
  CHECK(tight(power(Interval(-1, 1), 4), 0, 1));
  CHECK(power(Interval(-1, 1), 4).low() == 0);
  // The quotient of a negative exponent is rounded once more.
  const Interval half = power(Interval(2, 4), -1);
  CHECK(half.low() > 0.25 - 1e-15);
  CHECK(half.high() < 0.5 + 1e-15);
}

TEST_CASE("sums and products in two parts hold those of double, part by part") {
  Random random;
  long outside_parts = 0;
  const auto tame = [&] {
    double x = random.next_finite();
    while (std::abs(x) > 1e100 || std::abs(x) < 1e-100) x = random.next_finite();
    return x;
  };
  for (int i = 0; i < trials; ++i) {
    const double x = tame();
    const double y = tame();
    const Interval around_x(x, at_place(place(x) + i % 3));
    const Interval around_y(at_place(place(y) - i % 5), y);
    const auto judge = [&](const TwoParts<Interval>& bounds, const TwoParts<double>& parts) {
      outside_parts += bounds.high.contains(parts.high) && bounds.low.contains(parts.low) ? 0 : 1;
    };
    judge(two_sum(around_x, around_y), two_sum(x, y));
    judge(two_product(around_x, around_y), two_product(x, y));
  }
  CHECK(outside_parts == 0);
  CHECK(same(two_sum(Interval(1), Interval(2)).low, Interval(0)));
}

TEST_CASE("the scale of an interval is one power of two that brings its upper end near 1") {
  for (const double size : {1.0, 0.7, 3.0, 1e300, huge, Limits::min(), 1e-310}) {
    const Interval scale = power_of_two_scale(Interval(size / 2, size));
    CHECK(scale.is_point());
    CHECK(scale.low() == power_of_two_scale(size));
  }
  CHECK(same(power_of_two_scale(Interval(0)), Interval(1)));
  CHECK(same(power_of_two_scale(anything), Interval(1)));
}

TEST_CASE("around a single number the bounds are close") {
  Random random;
  std::int64_t basic = 0;
  std::int64_t library = 0;
  for (int i = 0; i < trials; ++i) {
    const double a = random.next_finite();
    const double b = random.next_finite();
    const Interval x(a);
    const Interval y(b);
    basic = std::max(
        {basic, steps(x + y), steps(x - y), steps(x * y), steps(sqrt(abs(x))), steps(square(x))});
    if (b != 0) basic = std::max(basic, steps(x / y));
    library = std::max({library, steps(exp(x)), steps(log1p(abs(x)))});
    if (b != 0) library = std::max(library, steps(atan2(y, x)));
  }
  CHECK(basic == 2);
  CHECK(library == 8);
}

#ifdef TEXMAP_HAVE_BOOST

// The law, judged by 50 digits.

/// The same for operations with an exact result, in 50 digits.
template <class Operation>
long outside_exact(int count, const Operation& operation, bool (*in_domain)(double, double)) {
  return outside<Digits50>(operation, count, [in_domain](double x, double y) {
    return std::isfinite(x) && std::isfinite(y) && in_domain(x, y);
  });
}

TEST_CASE("the exact result lies between the bounds") {
  const auto all = [](double, double) { return true; };
  CHECK(outside_exact(
            trials, [](auto a, auto b) { return a + b; }, all) == 0);
  CHECK(outside_exact(
            trials, [](auto a, auto b) { return a * b; }, all) == 0);
  CHECK(outside_exact(
            trials, [](auto a, auto b) { return a / b; },
            [](double, double y) { return y != 0; }) == 0);
  CHECK(outside_exact(
            trials, [](auto a, auto) { return square(a); }, all) == 0);
  CHECK(outside_exact(
            trials, [](auto a, auto) { return sqrt(a); },
            [](double x, double) { return x >= 0; }) == 0);
  // They take their time.
  CHECK(outside_exact(
            5000, [](auto y, auto x) { return atan2(y, x); },
            [](double y, double x) { return x != 0 || y != 0; }) == 0);
  CHECK(outside_exact(
            5000, [](auto a, auto) { return exp(a); },
            [](double x, double) { return std::abs(x) < 1000; }) == 0);
  CHECK(outside_exact(
            5000, [](auto a, auto) { return log1p(a); },
            [](double x, double) { return x > -1 && std::abs(x) < 1e300; }) == 0);
}

// Boost.Interval as a comparison. It switches the rounding mode (docs/packages.md).

using Checking = boost::numeric::interval_lib::checking_base<double>;
using Rounding = boost::numeric::interval_lib::rounded_math<double>;
using Theirs =
    boost::numeric::interval<double, boost::numeric::interval_lib::policies<Rounding, Checking> >;

TEST_CASE("Boost.Interval's bounds lie within ours, and ours at most two steps beyond them") {
  Random random;
  long outside_ours = 0;
  long far = 0;
  const auto judge = [&](const Interval& ours, const Theirs& theirs) {
    outside_ours += ours.low() <= theirs.lower() && theirs.upper() <= ours.high() ? 0 : 1;
    far += place(theirs.lower()) - place(ours.low()) <= 2 &&
                   place(ours.high()) - place(theirs.upper()) <= 2
               ? 0
               : 1;
  };
  for (int i = 0; i < trials; ++i) {
    const Interval a = random.interval(true);
    const Interval b = random.interval(true);
    const Theirs x(a.low(), a.high());
    const Theirs y(b.low(), b.high());
    judge(a + b, x + y);
    judge(a - b, x - y);
    judge(a * b, x * y);
    if (!b.may_be_zero()) judge(a / b, x / y);
    if (a.low() >= 0) judge(sqrt(a), boost::numeric::sqrt(x));
    judge(square(a), boost::numeric::square(x));
    judge(abs(a), boost::numeric::abs(x));
  }
  CHECK(outside_ours == 0);
  CHECK(far == 0);
}

#endif

}  // namespace
}  // namespace texmap::test
