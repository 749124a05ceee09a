// Random numbers that are the same on every machine: numbers and directions, spread evenly or over
// all exponents, and special values.
#pragma once
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "math/vec3.hpp"

namespace texmap::test {

/// Draws by splitmix64: equal seeds give equal draws.
class Dice {
 public:
  using Tape = std::vector<std::uint64_t>;

  explicit Dice(std::uint64_t seed = 1) : state_(seed) {}
  /// Draws what is on the tape first, and records on it what is drawn after its end.
  Dice(Tape& tape, std::uint64_t seed) : state_(seed), tape_(&tape) {}

  std::uint64_t bits() {
    if (tape_ == nullptr) return draw();
    if (taken_ == tape_->size()) tape_->push_back(draw());
    return (*tape_)[taken_++];
  }
  /// How many places of the tape were used.
  [[nodiscard]] std::size_t taken() const { return taken_; }
  /// 0 to n - 1.
  int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
  int within(int low, int high) { return low + below(high - low + 1); }
  /// True once in n draws.
  bool once_in(int n) { return below(n) == 0; }
  /// -1 or 1.
  int sign() { return once_in(2) ? -1 : 1; }
  /// [low, high), each place as likely as any other.
  long double uniform(long double low, long double high) {
    return low + (high - low) * static_cast<long double>(bits() >> 11) * 0x1p-53L;
  }
  /// The same in double, where rounding may reach `high`.
  double between(double low, double high) {
    return static_cast<double>(
        uniform(static_cast<long double>(low), static_cast<long double>(high)));
  }
  /// 10^low to 10^high, each power as likely as any other.
  long double power_of_ten(long double low, long double high) {
    return std::pow(10.0L, uniform(low, high));
  }
  /// The same in double, with either sign.
  double any_size(double low, double high) {
    return sign() * static_cast<double>(power_of_ten(static_cast<long double>(low),
                                                     static_cast<long double>(high)));
  }

  /// A positive number in [2^low, 2^high): all exponents are equally likely, all digits of T vary.
  template <class T>
  T number(int low, int high) {
    const T mantissa = static_cast<T>(1) + fraction<T>();
    using std::ldexp;  // a reference number brings its own
    return ldexp(mantissa, within(low, high - 1));
  }
  /// Any finite number, subnormal ones included, and once in 16 draws a zero with either sign.
  template <class T>
  T finite() {
    using Limits = std::numeric_limits<T>;
    const T size =
        once_in(16) ? T(0) : number<T>(Limits::min_exponent - Limits::digits, Limits::max_exponent);
    return sign() < 0 ? -size : size;
  }
  /// Anything that the type holds: also infinities, NaN, the range's ends, numbers around integers.
  template <class T>
  T anything() {
    using Limits = std::numeric_limits<T>;
    const int kind = below(16);
    if (kind < 2) return kind == 0 ? Limits::infinity() : -Limits::infinity();
    if (kind == 2) return Limits::quiet_NaN();
    if (kind == 3) return static_cast<T>(sign()) * Limits::max();
    if (kind == 4) return static_cast<T>(sign()) * Limits::denorm_min();
    if (kind == 5)
      return std::nextafter(static_cast<T>(within(-2, 2)), static_cast<T>(sign()) * T(9));
    if (kind == 6) return static_cast<T>(within(-3, 3));
    if (kind == 7) return static_cast<T>(sign()) * number<T>(-4, 90);
    return finite<T>();
  }
  /// A direction, each as likely as any other, one unit long but for rounding.
  template <class T = long double>
  Vec3<T> direction() {
    for (;;) {
      const Vec3<long double> p{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      const long double square_of_length = dot(p, p);
      if (square_of_length < 1 && square_of_length > 1e-4L)
        return number_cast<T>(p * (1 / std::sqrt(square_of_length)));
    }
  }
  /// A direction at a right angle to `p`.
  Vec3<long double> across(const Vec3<long double>& p) {
    for (;;) {
      const Vec3<long double> q = cross(p, direction());
      if (dot(q, q) > 1e-2L) return q * (1 / std::sqrt(dot(q, q)));
    }
  }

 private:
  /// The digits of T after the first, in [0, 1). One draw has 64: ARM64's long double takes two.
  template <class T>
  T fraction() {
    using Limits = std::numeric_limits<T>;
    constexpr int rest = Limits::digits - 1;
    if constexpr (rest <= 64) {
      return static_cast<T>(bits() >> (64 - rest)) * Limits::epsilon();
    } else {
      static_assert(rest <= 128);
      using std::ldexp;
      const T first = ldexp(static_cast<T>(bits()), -64);
      return first + static_cast<T>(bits() >> (128 - rest)) * Limits::epsilon();
    }
  }
  std::uint64_t draw() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
  Tape* tape_ = nullptr;
  std::size_t taken_ = 0;
};

/// A point of a cube around 0.
[[nodiscard]] inline Point point_within(Dice& dice, double reach) {
  return {dice.between(-reach, reach), dice.between(-reach, reach), dice.between(-reach, reach)};
}
/// A point with whole coordinates: rays from there are often in the planes of faces.
[[nodiscard]] inline Point whole_point_within(Dice& dice, int reach) {
  const auto whole = [&] { return static_cast<double>(dice.within(-reach, reach)); };
  return {whole(), whole(), whole()};
}

template <class T>
[[nodiscard]] Vec3<T> scaled(const Vec3<T>& p, int power_of_two) {
  return {std::ldexp(p.x, power_of_two), std::ldexp(p.y, power_of_two),
          std::ldexp(p.z, power_of_two)};
}

}  // namespace texmap::test
