// Intervals: numbers known to lie between two bounds. A lesson run with them gives certain bounds.
#pragma once
#include <bit>
#include <cfloat>
#include <concepts>
#include <cstdint>
#include <numbers>

#include "number/compensated.hpp"

namespace texmap {

/// The truth of a comparison of intervals: whether it can be true and whether it can be false.
/// At least one of the two holds. `&&` and `||` always compute both sides.
struct Tribool {
  bool can_be_true = false;
  bool can_be_false = true;

  /// Not what `if` needs: only words for whoever writes it.
  template <class Plain>
  requires std::is_same_v<Plain, bool>
  constexpr explicit operator Plain() const {
    static_assert(!sizeof(Plain),
                  "a comparison of intervals may be both true and false, which `if` and `? :` "
                  "cannot be: write select(mask, a, b) and any(mask), or say in the lesson's "
                  "`about` that its code branches: .numbers = Numbers::single");
    return {};
  }
  friend constexpr Tribool operator!(const Tribool& a) { return {a.can_be_false, a.can_be_true}; }
  friend constexpr Tribool operator&&(const Tribool& a, const Tribool& b) {
    return {a.can_be_true && b.can_be_true, a.can_be_false || b.can_be_false};
  }
  friend constexpr Tribool operator||(const Tribool& a, const Tribool& b) {
    return {a.can_be_true || b.can_be_true, a.can_be_false && b.can_be_false};
  }
  /// Work is skipped only if no number can need it.
  [[nodiscard]] friend constexpr bool any(const Tribool& a) { return a.can_be_true; }
};

class Interval;

template <>
struct NumberTraits<Interval> {
  using Scalar = double;  ///< the type of the bounds
  using Mask = Tribool;
  static constexpr std::size_t lanes = 1;
};

/// All numbers from `low()` to `high()`, both included; either may be infinite.
/// If x lies in X and y in Y, the exact x + y lies in X + Y; so it is for every function here.
/// A function that is undefined for some of its numbers gives the whole line, which includes NaN.
/// Domain: rounding to nearest, no flushing of subnormal numbers.
/// Bound: rounding moves each end outward by one number, in atan2, exp, log1p and power by four.
/// Source: Moore, Kearfott and Cloud, Introduction to Interval Analysis (2009).
class Interval {
 public:
  using Mask = Tribool;

  constexpr Interval() = default;
  /// The one number `number`, or the two doubles around it. NaN gives the whole line.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  constexpr explicit Interval(Number number)
      : Interval(lower(static_cast<double>(number), exact(number)),
                 upper(static_cast<double>(number), exact(number))) {}
  /// @param low, high  low <= high; a NaN means no bound on that side
  constexpr Interval(double low, double high) : low_(lower(low, true)), high_(upper(high, true)) {}

  /// The whole line: anything.
  [[nodiscard]] static constexpr Interval anything() { return {-infinite, infinite}; }

  [[nodiscard]] constexpr double low() const { return low_; }
  [[nodiscard]] constexpr double high() const { return high_; }
  [[nodiscard]] constexpr bool is_point() const { return low_ == high_; }
  [[nodiscard]] constexpr bool is_anything() const {
    return low_ == -infinite && high_ == infinite;
  }
  [[nodiscard]] constexpr bool is_unbounded() const {
    return low_ == -infinite || high_ == infinite;
  }
  /// True for infinity itself, false for an interval without a bound.
  [[nodiscard]] constexpr bool is_infinite() const {
    return low_ == infinite || high_ == -infinite;
  }
  [[nodiscard]] constexpr bool may_be_zero() const { return low_ <= 0 && high_ >= 0; }
  /// True where x lies in the interval; a NaN lies only in the whole line.
  template <std::floating_point Number>
  [[nodiscard]] constexpr bool contains(Number x) const {
    using Wider = std::common_type_t<Number, double>;
    return (Wider{low_} <= Wider{x} && Wider{x} <= Wider{high_}) || is_anything();
  }
  /// The smallest interval that holds both.
  [[nodiscard]] friend constexpr Interval hull(const Interval& a, const Interval& b) {
    return {a.low_ < b.low_ ? a.low_ : b.low_, a.high_ > b.high_ ? a.high_ : b.high_};
  }

  friend constexpr Interval operator+(const Interval& a, const Interval& b) {
    const double low = a.low_ + b.low_;
    const double high = a.high_ + b.high_;
    return {lower(low, is_exact_sum(low, a.low_, b.low_)),
            upper(high, is_exact_sum(high, a.high_, b.high_))};
  }
  friend constexpr Interval operator-(const Interval& a, const Interval& b) { return a + -b; }
  friend constexpr Interval operator-(const Interval& a) { return {-a.high_, -a.low_}; }

  friend constexpr Interval operator*(const Interval& a, const Interval& b) {
    // The signs tell the smallest and the largest product, unless both intervals contain zero.
    double low = 0;
    double high = 0;
    if (a.low_ >= 0) {
      low = (b.low_ >= 0 ? a.low_ : a.high_) * b.low_;
      high = (b.high_ >= 0 ? a.high_ : a.low_) * b.high_;
    } else if (a.high_ <= 0) {
      low = (b.high_ >= 0 ? a.low_ : a.high_) * b.high_;
      high = (b.low_ >= 0 ? a.high_ : a.low_) * b.low_;
    } else if (b.low_ >= 0) {
      low = a.low_ * b.high_;
      high = a.high_ * b.high_;
    } else if (b.high_ <= 0) {
      low = a.high_ * b.low_;
      high = a.low_ * b.low_;
    } else {
      low = least(a.low_ * b.high_, a.high_ * b.low_);
      high = most(a.low_ * b.low_, a.high_ * b.high_);
    }
    if (a.is_unbounded() || b.is_unbounded()) {
      if ((a.is_unbounded() && b.may_be_zero()) || (b.is_unbounded() && a.may_be_zero()))
        return anything();
      if (a.is_infinite() || b.is_infinite()) return {low, high};
    }
    return outward(low, high, is_power_of_two(a) || is_power_of_two(b), sign_of(a, b));
  }
  friend constexpr Interval operator/(const Interval& a, const Interval& b) {
    if (b.may_be_zero()) return anything();
    if (a.is_unbounded() && b.is_unbounded()) return anything();
    const double smallest = b.low_ > 0 ? a.low_ : a.high_;
    const double largest = b.low_ > 0 ? a.high_ : a.low_;
    const double low = smallest / (smallest >= 0 ? b.high_ : b.low_);
    const double high = largest / (largest >= 0 ? b.low_ : b.high_);
    if (a.is_infinite() || b.is_infinite()) return {low, high};
    return outward(low, high, is_power_of_two(b), sign_of(a, b));
  }

  // A NaN makes every comparison false, and the whole line includes NaN.
  friend constexpr Tribool operator<(const Interval& a, const Interval& b) {
    return {a.low_ < b.high_, !(a.high_ < b.low_)};
  }
  friend constexpr Tribool operator<=(const Interval& a, const Interval& b) {
    return {a.low_ <= b.high_, !(a.high_ <= b.low_) || a.is_anything() || b.is_anything()};
  }
  friend constexpr Tribool operator>(const Interval& a, const Interval& b) { return b < a; }
  friend constexpr Tribool operator>=(const Interval& a, const Interval& b) { return b <= a; }
  friend constexpr Tribool operator==(const Interval& a, const Interval& b) {
    return {a.low_ <= b.high_ && b.low_ <= a.high_, !(a.high_ == b.low_ && a.low_ == b.high_)};
  }

  /// The side that the mask certainly chooses, else the hull of both.
  friend constexpr Interval select(const Tribool& mask, const Interval& yes, const Interval& no) {
    if (!mask.can_be_false) return yes;
    if (!mask.can_be_true) return no;
    return hull(yes, no);
  }
  /// The larger of two numbers; select(a > b, a, b) would give a wider hull, [1, 4] for [2, 4].
  friend constexpr Interval max(const Interval& a, const Interval& b) {
    if (b.is_anything()) return b;
    return {a.low_ > b.low_ ? a.low_ : b.low_, a.high_ > b.high_ ? a.high_ : b.high_};
  }
  friend constexpr Interval min(const Interval& a, const Interval& b) {
    if (b.is_anything()) return b;
    return {a.low_ < b.low_ ? a.low_ : b.low_, a.high_ < b.high_ ? a.high_ : b.high_};
  }

  friend constexpr Interval abs(const Interval& a) {
    if (a.low_ >= 0 || a.is_anything()) return a;
    if (a.high_ <= 0) return -a;
    return {0.0, -a.low_ > a.high_ ? -a.low_ : a.high_};
  }
  friend Interval floor(const Interval& a) { return {std::floor(a.low_), std::floor(a.high_)}; }
  /// x * x for one x, never below 0; [-1, 2] * [-1, 2] would reach down to -2.
  friend constexpr Interval square(const Interval& a) {
    if (a.is_anything()) return a;
    const Interval size = abs(a);
    return outward(size.low_ * size.low_, size.high_ * size.high_, is_power_of_two(a),
                   {.never_negative = true});
  }
  friend Interval sqrt(const Interval& a) {
    if (!(a.low_ >= 0)) return anything();
    // Only 0, 1 and infinity have an exact root that is known without computing.
    const auto is_known = [](double x) { return x == 0 || x == 1 || x == infinite; };
    return {lower(std::sqrt(a.low_), is_known(a.low_)),
            upper(std::sqrt(a.high_), is_known(a.high_))};
  }
  friend Interval exp(const Interval& a) {
    if (a.is_anything()) return a;
    const Interval wide = widened_by_4(texmap::exp(a.low_), texmap::exp(a.high_));
    return {wide.low_ > 0 ? wide.low_ : 0, wide.high_};
  }
  friend Interval log1p(const Interval& a) {
    if (!(a.low_ >= -1)) return anything();
    return widened_by_4(texmap::log1p(a.low_), texmap::log1p(a.high_));
  }
  /// The angle of the points (x, y) of a box; [-pi, pi] for a box that touches the origin or the
  /// negative x axis, where the angle jumps: zeros have no sign here.
  friend Interval atan2(const Interval& y, const Interval& x) {
    if (y.is_anything() || x.is_anything()) return anything();
    const double half_turn = next_up(std::numbers::pi);
    if (y.low_ <= 0 && y.high_ >= 0 && x.low_ <= 0) return {-half_turn, half_turn};
    // The angle does not jump inside the box, so its bounds are at corners; the signs tell which.
    const double last_x = y.low_ >= 0 ? x.high_ : x.low_;
    const double last_y = last_x >= 0 ? y.low_ : y.high_;
    const double first_x = y.high_ >= 0 ? x.low_ : x.high_;
    const double first_y = first_x >= 0 ? y.high_ : y.low_;
    const Interval wide =
        widened_by_4(texmap::atan2(last_y, last_x), texmap::atan2(first_y, first_x));
    return {wide.low_ > -half_turn ? wide.low_ : -half_turn,
            wide.high_ < half_turn ? wide.high_ : half_turn};
  }
  /// x to the power of a plain number; a negative x has powers only for whole exponents.
  friend Interval power(const Interval& x, double exponent) {
    if (exponent < 0) return Interval(1) / power(x, -exponent);
    const bool whole = std::floor(exponent) == exponent;
    const bool even = whole && std::floor(exponent / 2) == exponent / 2;
    if (x.is_anything() || (x.low_ < 0 && !whole)) return anything();
    const Interval base = even ? abs(x) : x;
    const Interval wide =
        widened_by_4(texmap::pow(base.low_, exponent), texmap::pow(base.high_, exponent));
    return {base.low_ >= 0 && !(wide.low_ >= 0) ? 0 : wide.low_, wide.high_};
  }
  /// The hull of all table entries where the place may lie, channel by channel.
  template <class Table>
  friend std::array<Interval, 3> look_up(const Table& table, const Interval& column,
                                         const Interval& row) {
    auto least = table(static_cast<int>(column.low_), static_cast<int>(row.low_));
    auto most = least;
    for (int y = static_cast<int>(row.low_); y <= static_cast<int>(row.high_); ++y) {
      for (int x = static_cast<int>(column.low_); x <= static_cast<int>(column.high_); ++x) {
        const auto entry = table(x, y);
        for (std::size_t k = 0; k < 3; ++k) {
          least[k] = entry[k] < least[k] ? entry[k] : least[k];
          most[k] = entry[k] > most[k] ? entry[k] : most[k];
        }
      }
    }
    const auto channel = [&](std::size_t k) {
      return Interval(static_cast<double>(least[k]), static_cast<double>(most[k]));
    };
    return {channel(0), channel(1), channel(2)};
  }

 private:
  static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0,
                "a double operation must round once, as a double");
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  /// The next number below x. For -infinity and NaN it is NaN, which means no bound.
  [[nodiscard]] static constexpr double next_down(double x) {
    // The bits of doubles of one sign are ordered like integers. 0 becomes -0 first.
    const auto bits = std::bit_cast<std::int64_t>(-(0.0 - x));
    return std::bit_cast<double>(bits < 0 ? bits + 1 : bits - 1);
  }
  /// The next number above x. For infinity and NaN, NaN.
  [[nodiscard]] static constexpr double next_up(double x) { return -next_down(-x); }

  /// A lower bound of what was rounded to x: x itself if x is known not to be too large.
  [[nodiscard]] static constexpr double lower(double x, bool not_too_large) {
    if (!not_too_large) return next_down(x);
    return x >= -infinite ? x : -infinite;
  }
  [[nodiscard]] static constexpr double upper(double x, bool not_too_small) {
    return -lower(-x, not_too_small);
  }

  /// True when `sum`, the rounded a + b, is exact: subtracting one of the two gives the other.
  /// Source: Dekker (1971).
  [[nodiscard]] static constexpr bool is_exact_sum(double sum, double a, double b) {
    return (sum - a == b && sum - b == a) || (sum - sum != 0 && (sum == a || sum == b));
  }

  [[nodiscard]] static constexpr bool is_power_of_two(const Interval& a) {
    const auto bits = std::bit_cast<std::uint64_t>(a.low_);
    const auto exponent = (bits >> 52U) & 0x7FFU;
    return bits << 12U == 0 && a.is_point() && exponent != 0 && exponent != 0x7FFU;
  }
  /// The sign of all products and quotients of two intervals, if it is the same.
  struct Sign {
    bool never_negative = false;
    bool never_positive = false;
  };
  [[nodiscard]] static constexpr Sign sign_of(const Interval& a, const Interval& b) {
    const bool zero = (a.low_ == 0 && a.high_ == 0) || (b.low_ == 0 && b.high_ == 0);
    return {zero || (a.low_ >= 0 && b.low_ >= 0) || (a.high_ <= 0 && b.high_ <= 0),
            zero || (a.low_ >= 0 && b.high_ <= 0) || (a.high_ <= 0 && b.low_ >= 0)};
  }
  /// The bounds of what was rounded to `low` and `high`, without changing the sign.
  ///
  /// @param scaled  a factor was a power of two: then results in the normal range are exact
  [[nodiscard]] static constexpr Interval outward(double low, double high, bool scaled, Sign sign) {
    const double below = lower(low, scaled && has_all_digits(low));
    const double above = upper(high, scaled && has_all_digits(high));
    return {sign.never_negative && below < 0 ? 0 : below,
            sign.never_positive && above > 0 ? 0 : above};
  }
  [[nodiscard]] static constexpr bool has_all_digits(double x) {
    const double size = x < 0 ? -x : x;
    return size > std::numeric_limits<double>::min() && size < infinite;  // it may be rounded up
  }
  [[nodiscard]] static constexpr double least(double a, double b) { return a < b ? a : b; }
  [[nodiscard]] static constexpr double most(double a, double b) { return a > b ? a : b; }

  [[nodiscard]] static constexpr Interval widened_by_4(double low, double high) {
    for (int i = 0; i < 4; ++i) {
      low = next_down(low);
      high = next_up(high);
    }
    return {low, high};
  }

  /// True when a double holds every digit of `number`.
  template <class Number>
  [[nodiscard]] static constexpr bool exact(Number number) {
    if constexpr (std::numeric_limits<Number>::digits <= std::numeric_limits<double>::digits) {
      return true;
    } else if constexpr (std::floating_point<Number>) {
      return static_cast<Number>(static_cast<double>(number)) == number;
    } else {
      constexpr auto largest = Number(1) << std::numeric_limits<double>::digits;
      return number <= largest && (std::is_unsigned_v<Number> || number >= -largest);
    }
  }

  double low_ = 0;
  double high_ = 0;
};

/// Pi lies between the two doubles nearest to it.
template <>
[[nodiscard]] inline Interval pi<Interval>() {
  return {0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1};
}

/// Holds the answer for double and for every number with more digits.
template <>
[[nodiscard]] inline Interval below_one<Interval>() {
  return {0x1.fffffffffffffp-1, 1.0};
}

/// Half a unit in the last place of any number in the interval, of either sign; 0 for a point.
[[nodiscard]] inline Interval rounding_error_in(const Interval& a) {
  return a.is_point() ? Interval(0) : abs(a) * Interval(-0x1p-53, 0x1p-53);
}

/// a + b and its rounding error; the general form would count the width of a and b three times.
[[nodiscard]] inline TwoParts<Interval> two_sum(const Interval& a, const Interval& b) {
  const Interval sum = a + b;
  return {sum, rounding_error_in(sum)};
}

/// a b and its rounding error.
[[nodiscard]] inline TwoParts<Interval> two_product(const Interval& a, const Interval& b) {
  const Interval product = a * b;
  return {product, rounding_error_in(product)};
}

/// A power of two that scales the upper end of `size` into [1, 2); no hull: any scale will do.
[[nodiscard]] inline Interval power_of_two_scale(const Interval& size) {
  if (!(size.high() > 0 && size.high() <= std::numeric_limits<double>::max())) return Interval(1);
  const int exponent = -std::ilogb(size.high());
  return Interval(ldexp(1.0, exponent < 1023 ? exponent : 1023));
}

/// Only words for whoever calls these; `Any` is Interval.
template <std::same_as<Interval> Any, class... More>
Any sin(const Any& x, const More&... /*exponent*/) {
  static_assert(!sizeof(Any),
                "intervals have no sin, cos, pow or ldexp: say in the lesson's `about`: .numbers = "
                "Numbers::no_intervals");
  return x;
}
template <std::same_as<Interval> Any>
Any cos(const Any& x) {
  return sin(x);
}
template <std::same_as<Interval> Any>
Any pow(const Any& x, const auto& exponent) {
  return sin(x, exponent);
}

}  // namespace texmap
