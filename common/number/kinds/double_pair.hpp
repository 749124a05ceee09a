// Pairs of doubles: a number of about 31 decimal digits on every machine that has double.
#pragma once
#include <algorithm>
#include <compare>
#include <concepts>
#include <numbers>
#include <type_traits>

#include "number/compensated.hpp"

namespace texmap {

/// The number high + low; `high` is the double nearest to it, so |low| <= half an ulp of `high`.
/// Domain: rounding to nearest; operands and results zero or of size 1e-270 to 1e290.
/// Bound: +, -, *, / and sqrt are within 2^-102 of themselves, the unit roundoff.
/// Source: Dekker (1971); Joldes, Muller and Popescu, "Tight and Rigorous Error Bounds for Basic
/// Building Blocks of Double-Word Arithmetic" (2017).
struct DoublePair {
  double high = 0;
  double low = 0;

  constexpr DoublePair() = default;
  /// `x` without an error; of integers only those that a double holds.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  constexpr explicit DoublePair(Number x) : high(static_cast<double>(x)) {
    if constexpr (std::floating_point<Number>) {
      if (high - high == 0) low = static_cast<double>(x - static_cast<Number>(high));
    }
  }
  /// @param high, low  |low| <= half an ulp of `high`
  constexpr DoublePair(double high_part, double low_part) : high(high_part), low(low_part) {}
  /// a + b without an error. What is not finite has no low part.
  [[nodiscard]] static DoublePair sum(double a, double b) {
    const TwoParts<double> parts = two_sum(a, b);
    return {parts.high, parts.high - parts.high == 0 ? parts.low : 0};
  }

  template <std::floating_point Number>
  constexpr explicit operator Number() const {
    return static_cast<Number>(high) + static_cast<Number>(low);
  }
  /// Cut off towards zero. Domain: the results are in the range of int.
  explicit operator int() const {
    const auto whole = static_cast<int>(high);
    if (static_cast<double>(whole) != high) return whole;
    return whole - (high > 0 && low < 0 ? 1 : 0) + (high < 0 && low > 0 ? 1 : 0);
  }

  /// By the high parts, then by the low ones; a NaN makes every comparison false.
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 of <=> for a pointer
  friend constexpr auto operator<=>(const DoublePair&, const DoublePair&) = default;

  friend DoublePair operator-(const DoublePair& a) { return {-a.high, -a.low}; }
  friend DoublePair operator+(const DoublePair& a, const DoublePair& b) {
    const DoublePair highs = sum(a.high, b.high);
    if (!highs.is_finite()) return highs;
    const DoublePair lows = sum(a.low, b.low);
    const DoublePair most = sum(highs.high, highs.low + lows.high);
    return sum(most.high, most.low + lows.low);
  }
  friend DoublePair operator-(const DoublePair& a, const DoublePair& b) { return a + -b; }
  friend DoublePair operator*(const DoublePair& a, const DoublePair& b) {
    const TwoParts<double> highs = two_product(a.high, b.high);
    if (!DoublePair(highs.high).is_finite()) return DoublePair(highs.high);
    return sum(highs.high, highs.low + (a.high * b.low + a.low * b.high));
  }
  /// Long division: what the first quotient leaves over is divided again.
  friend DoublePair operator/(const DoublePair& a, const DoublePair& b) {
    const DoublePair quotient(a.high / b.high);
    if (!quotient.is_finite() || b.high - b.high != 0) return quotient;
    return sum(quotient.high, (a - b * quotient).high / b.high);
  }

  [[nodiscard]] constexpr bool is_finite() const { return high - high == 0; }
};

}  // namespace texmap

template <>
class std::numeric_limits<texmap::DoublePair> {
  using Double = std::numeric_limits<double>;
  using Pair = texmap::DoublePair;

 public:
  static constexpr int digits = 102;  ///< that every operation gets right; numbers may have more
  static constexpr int min_exponent = Double::min_exponent;
  static constexpr int max_exponent = Double::max_exponent;
  static constexpr Pair epsilon() { return {0x1p-101, 0}; }
  static constexpr Pair min() { return {Double::min(), 0}; }
  static constexpr Pair max() { return {Double::max(), Double::max() * 0x1p-54}; }
  static constexpr Pair infinity() { return {Double::infinity(), 0}; }
  static constexpr Pair quiet_NaN() { return {Double::quiet_NaN(), 0}; }
};

namespace texmap {

/// Pi to 107 digits in base 2.
template <>
[[nodiscard]] inline DoublePair pi<DoublePair>() {
  return {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
}

/// A pair has digits to spare: the rounding error of its sums and products is taken to be 0.
[[nodiscard]] inline TwoParts<DoublePair> two_sum(const DoublePair& a, const DoublePair& b) {
  return {a + b, DoublePair()};
}
[[nodiscard]] inline TwoParts<DoublePair> two_product(const DoublePair& a, const DoublePair& b) {
  return {a * b, DoublePair()};
}

[[nodiscard]] inline DoublePair abs(const DoublePair& a) { return a.high < 0 ? -a : a; }
[[nodiscard]] inline DoublePair floor(const DoublePair& a) {
  const double high = std::floor(a.high);
  return high == a.high ? DoublePair::sum(high, std::floor(a.low)) : DoublePair(high);
}
[[nodiscard]] inline DoublePair ldexp(const DoublePair& a, int exponent) {
  return {std::ldexp(a.high, exponent), std::ldexp(a.low, exponent)};
}
/// The remainder with the sign of `a`. Domain: |a / b| below 2^50.
[[nodiscard]] inline DoublePair fmod(const DoublePair& a, const DoublePair& b) {
  const DoublePair ratio = a / b;
  return a - b * (ratio.high < 0 ? -floor(-ratio) : floor(ratio));
}
/// One step of Newton's iteration from the root of the high part.
[[nodiscard]] inline DoublePair sqrt(const DoublePair& a) {
  const DoublePair root(std::sqrt(a.high));
  if (!(root.high > 0) || !root.is_finite()) return root;
  return DoublePair::sum(root.high, (a - root * root).high / (2 * root.high));
}

/// e^x. Bound: 1e-31 (1 + |x|) of itself.
[[nodiscard]] inline DoublePair exp(const DoublePair& x) {
  if (!(std::abs(x.high) < 690)) return DoublePair(texmap::exp(x.high));
  const DoublePair log_2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
  const double powers_of_two = std::floor(x.high / log_2.high + 0.5);
  const DoublePair rest = x - log_2 * DoublePair(powers_of_two);
  DoublePair term(1);
  DoublePair series(1);
  for (int n = 1; n <= 27; ++n) {
    term = term * rest / DoublePair(n);
    series = series + term;
  }
  return ldexp(series, static_cast<int>(powers_of_two));
}
/// log(1 + x), by one step of Newton's iteration from double's logarithm.
/// Domain: x >= -0.98; nearer to -1 the step leaves more. Bound: 1e-30 of itself or of 1.
[[nodiscard]] inline DoublePair log1p(const DoublePair& x) {
  const DoublePair number = DoublePair(1) + x;
  const DoublePair near(texmap::log1p(x.high));
  return near.is_finite() ? near + (number * exp(-near) - DoublePair(1)) : near;
}
/// Domain: whole exponents from 0 to 1000; others give NaN.
[[nodiscard]] inline DoublePair pow(const DoublePair& x, const DoublePair& exponent) {
  if (!(exponent == floor(exponent) && exponent.high >= 0 && exponent.high <= 1000))
    return std::numeric_limits<DoublePair>::quiet_NaN();
  DoublePair product(1);
  for (int i = 0; i < static_cast<int>(exponent); ++i) product = product * x;
  return product;
}

/// sin(x + quarters of a turn), by Taylor's series around the nearest quarter turn.
/// Domain: |x| <= 1e6. Bound: 1e-31 (1 + |x|), absolute; 1e-31 of itself for x up to pi / 4.
[[nodiscard]] inline DoublePair sine(const DoublePair& x, int quarters) {
  if (!(std::abs(x.high) <= 1e6)) return std::numeric_limits<DoublePair>::quiet_NaN();
  const double nearest = std::floor(x.high / (std::numbers::pi / 2) + 0.5);
  const DoublePair rest = x - pi<DoublePair>() * DoublePair(nearest / 2);
  const int quarter = (static_cast<int>(nearest) + quarters) & 3;
  const bool odd = quarter % 2 == 1;
  DoublePair term = odd ? DoublePair(1) : rest;
  DoublePair series = term;
  for (int n = odd ? 1 : 2; n < 30; n += 2) {
    term = -term * rest * rest / DoublePair(n * (n + 1));
    series = series + term;
  }
  return quarter < 2 ? series : -series;
}
[[nodiscard]] inline DoublePair sin(const DoublePair& x) { return sine(x, 0); }
[[nodiscard]] inline DoublePair cos(const DoublePair& x) { return sine(x, 1); }

/// The angle of (x, y): double's angle, plus the small one by which it misses.
/// Bound: 1e-31 of itself.
[[nodiscard]] inline DoublePair atan2(const DoublePair& y, const DoublePair& x) {
  const DoublePair near(texmap::atan2(y.high, x.high));
  const double size = std::max(std::abs(x.high), std::abs(y.high));
  if (!(size > 0 && size < std::numeric_limits<double>::infinity())) return near;
  const DoublePair c = cos(near);
  const DoublePair s = sin(near);
  return near + (y * c - x * s) / (x * c + y * s);
}
[[nodiscard]] inline DoublePair acos(const DoublePair& x) {
  return atan2(sqrt((DoublePair(1) - x) * (DoublePair(1) + x)), x);
}

}  // namespace texmap
