// Elementary functions made of +, -, *, / and roots, which every machine rounds alike: a picture is
// the same with every C library, and packs compute what single numbers do. number.hpp declares them
// for plain numbers, where a float is computed in double and rounded once. docs/numerics.md.
#pragma once
#include <bit>
#include <type_traits>

#include "number/compensated.hpp"

namespace texmap::elementary {

/// Taylor's series, their factors computed by the compiler, with as many terms as T has digits for.
template <class T>
struct Series {
  static constexpr int digits = std::numeric_limits<T>::digits;
  static constexpr std::size_t terms(std::size_t of_float, std::size_t of_double, std::size_t of_64,
                                     std::size_t of_113) {
    return digits <= 24 ? of_float : digits <= 53 ? of_double : digits <= 64 ? of_64 : of_113;
  }
  std::array<T, terms(7, 13, 15, 26)> exponential{};    ///< (e^x - 1 - x) / x^2 in x, to log(2) / 2
  std::array<T, terms(5, 10, 12, 22)> logarithm{};      ///< (2 artanh(s) - 2 s) / s^3 in s^2
  std::array<T, terms(6, 12, 15, 25)> of_pow{};         ///< more: an exponent multiplies its error
  std::array<T, terms(4, 8, 10, 15)> sine{}, cosine{};  ///< sin x / x - 1, cos x - 1, over x^2
  std::array<T, terms(4, 4, 26, 46)> arc_tangent{};     ///< (atan t / t - 1) / t^2 in t^2

  constexpr Series() {
    T factor = T(1);
    for (std::size_t k = 0; k < exponential.size(); ++k)
      exponential[k] = factor = factor / static_cast<T>(k + 2);
    for (std::size_t k = 0; k < of_pow.size(); ++k) {
      of_pow[k] = T(2) / static_cast<T>(2 * k + 3);
      if (k < logarithm.size()) logarithm[k] = of_pow[k];
    }
    for (std::size_t k = 0; k < sine.size(); ++k) {
      const auto n = static_cast<T>(2 * k + 2);
      cosine[k] = -(k == 0 ? T(1) : cosine[k - 1]) / (n * (n - T(1)));
      sine[k] = -(k == 0 ? T(1) : sine[k - 1]) / (n * (n + T(1)));
    }
    for (std::size_t k = 0; k < arc_tangent.size(); ++k)
      arc_tangent[k] = (k % 2 == 0 ? T(-1) : T(1)) / static_cast<T>(2 * k + 3);
  }
};
template <class T>
inline constexpr Series<T> series;

/// The sum of factors[k] x^(k - first) from `first` on, by Horner's rule.
template <class Real, std::size_t terms>
[[nodiscard]] Real power_series(const Real& x, const std::array<Scalar<Real>, terms>& factors,
                                std::size_t first = 0) {
  Real sum = Real(factors.back());
  for (std::size_t k = terms - 1; k-- > first;) sum = sum * x + Real(factors[k]);
  return sum;
}

/// The unsigned integer with as many bits as a float or a double.
template <class T>
using BitsOf = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;

/// The number whose bits are of(the bits of x). Packs have their own.
template <std::floating_point T, class Function>
[[nodiscard]] T map_bits(T x, const Function& of) {
  return std::bit_cast<T>(of(std::bit_cast<BitsOf<T>>(x)));
}

/// 2^n in each lane, for whole numbers in the range of the exponents of Real.
template <class Real>
[[nodiscard]] Real power_of_two(const Real& n) {
  using T = Scalar<Real>;
  using Limits = std::numeric_limits<T>;
  if constexpr (Limits::digits > 53) {
    return ldexp(Real(1), static_cast<int>(n));
  } else {  // the last digit of this sum is 1, so its last bits are an exponent
    constexpr T last_is_one = T(1.5) / Limits::epsilon();
    return map_bits(n + Real(last_is_one + (Limits::max_exponent - 1)),
                    [](auto bits) { return bits << (Limits::digits - 1); });
  }
}

/// x = mantissa 2^exponent with a mantissa from sqrt(1/2) to sqrt(2). Domain: normal numbers > 0.
template <class Real>
struct BinaryParts {
  Real mantissa, exponent;

  explicit BinaryParts(const Real& x) {
    using T = Scalar<Real>;
    using Limits = std::numeric_limits<T>;
    if constexpr (Limits::digits > 53) {
      int power = 0;
      mantissa = std::frexp(x, &power);
      exponent = static_cast<T>(power);
    } else {
      constexpr int place = Limits::digits - 1;
      constexpr T last_is_one = T(1) / Limits::epsilon();
      constexpr auto half = std::bit_cast<BitsOf<T>>(T(0.5));
      constexpr auto whole = std::bit_cast<BitsOf<T>>(last_is_one);
      constexpr BitsOf<T> below = (BitsOf<T>(1) << place) - 1;
      mantissa = map_bits(x, [](auto bits) { return (bits & below) | half; });
      exponent = map_bits(x, [](auto bits) { return (bits >> place) | whole; }) -
                 Real(last_is_one + (Limits::max_exponent - 2));
    }
    const Mask<Real> low = mantissa < Real(static_cast<T>(0.70710678118654752440L));
    mantissa = select(low, mantissa * Real(T(2)), mantissa);
    exponent = exponent - select(low, Real(T(1)), Real(T(0)));
  }
};

// log 2 in two parts: exponents (in double whole numbers up to 2^15) times the upper one are exact.
template <class T>
inline constexpr T log_2_high = static_cast<T>(Series<T>::digits == 24 ? 0x1.62e4p-1L
                                                                       : 0x1.62e42fefap-1L);
template <class T>
inline constexpr T log_2_low = static_cast<T>(
    Series<T>::digits == 24   ? 0x0.00002fefa39ef35793c7p-1L
    : Series<T>::digits <= 64 ? 0x0.00000000039ef35793c7673p-1L
                              : 0x0.00000000039ef35793c7673007e5ed5e81e6864ce5316cp-1L);

/// e^(x + low); 0 and infinity where no number of Real is as small or as large. Bound: 1 ulp.
///
/// @param low  at most an ulp of `x`
template <class Real>
[[nodiscard]] Real exp(const Real& x, const Real& low = Real(Scalar<Real>(0))) {
  using T = Scalar<Real>;
  using Limits = std::numeric_limits<T>;
  const T log_2 = static_cast<T>(0.6932L);
  const Real inside =
      clamp(x, Real(log_2 * static_cast<T>(Limits::min_exponent - Limits::digits - 2)),
            Real(log_2 * static_cast<T>(Limits::max_exponent)));
  const Real twos = floor(inside * Real(static_cast<T>(1.44269504088896340736L)) + Real(T(0.5)));
  const Real high = inside - twos * Real(log_2_high<T>);
  const Real below = twos * Real(log_2_low<T>) - low;
  const Real rest = high - below;
  const Real lost = (high - rest) - below;
  const Real power =
      Real(T(1)) + (rest + (rest * rest * power_series(rest, series<T>.exponential) + lost));
  const Real half = floor(twos * Real(T(0.5)));  // in two steps: 2^twos alone may be no number
  const Mask<Real> is_number = x == x;           // NaN is not; NOLINT(misc-redundant-expression)
  return select(is_number, power * power_of_two(half) * power_of_two(twos - half), x);
}

/// log(1 + x): -infinity at -1, NaN below. Bound: 1 ulp.
template <class Real>
[[nodiscard]] Real log1p(const Real& x) {
  using T = Scalar<Real>;
  const TwoParts<Real> sum = two_sum(Real(1), x);
  const Mask<Real> ordinary = sum.high > Real(0) && sum.high < infinity<Real>();
  const Real number = select(ordinary, sum.high, Real(1));
  const BinaryParts<Real> parts(number);
  const Real f = parts.mantissa - Real(1);
  const Real s = f / (Real(2) + f);
  const Real half_square = Real(T(0.5)) * f * f;
  const Real tail = s * s * power_series(s * s, series<T>.logarithm);
  // log(1 + f) = f - f^2 / 2 + s (f^2 / 2 + tail), the small parts first.
  const Real small = parts.exponent * Real(log_2_low<T>) + sum.low / number;
  const Real logarithm = parts.exponent * Real(log_2_high<T>) -
                         ((half_square - (s * (half_square + tail) + small)) - f);
  const Real undefined = Real(std::numeric_limits<T>::quiet_NaN());
  const Real beyond =
      select(sum.high == Real(0), -infinity<Real>(), select(x < Real(0), undefined, x));
  return select(ordinary, select(x == Real(0), x, logarithm), beyond);
}

/// log x with twice the digits of a plain number. Domain: normal numbers > 0.
template <class T>
[[nodiscard]] TwoParts<T> log_in_parts(T x) {
  const auto product = [](const TwoParts<T>& a, const TwoParts<T>& b) {
    const TwoParts<T> highs = two_product(a.high, b.high);
    return two_sum(highs.high, highs.low + (a.high * b.low + a.low * b.high));
  };
  const BinaryParts<T> parts(x);
  // log m = 2 s + s^3 (2/3 + 2/5 s^2 + ...) with s = (m - 1) / (m + 1).
  const TwoParts<T> divisor = two_sum(parts.mantissa, T(1));
  const T f = parts.mantissa - T(1);
  const T quotient = f / divisor.high;
  const TwoParts<T> back = two_product(quotient, divisor.high);
  const TwoParts<T> s{quotient,
                      (((f - back.high) - back.low) - quotient * divisor.low) / divisor.high};
  const TwoParts<T> square = product(s, s);
  const T two_thirds = series<T>.of_pow[0];
  const TwoParts<T> thrice = two_product(T(3), two_thirds);  // rounded, it would be 2
  const T two_thirds_low = ((T(2) - thrice.high) - thrice.low) / T(3);
  const TwoParts<T> factor =
      two_sum(two_thirds, square.high * power_series(square.high, series<T>.of_pow, 1));
  const TwoParts<T> cube = product(product(square, s), {factor.high, factor.low + two_thirds_low});
  const TwoParts<T> first = two_sum(parts.exponent * log_2_high<T>, T(2) * s.high);
  const TwoParts<T> sum = two_sum(first.high, cube.high);
  return two_sum(sum.high,
                 sum.low + (first.low + cube.low + T(2) * s.low + parts.exponent * log_2_low<T>));
}

/// x^y of plain numbers, as std::pow. Bound: 1.5 ulp of a normal number; for subnormal x, and in
/// long double, 3.
template <class T>
[[nodiscard]] T pow(T x, T y) {
  if (x == T(1) || y == T(0)) return T(1);
  const T size = abs(x);
  const bool whole = floor(y) == y;
  const bool odd = whole && floor(y / T(2)) * T(2) != y;
  if (std::isnan(x) || std::isnan(y) || (x < T(0) && size < infinity<T>() && !whole))
    return std::numeric_limits<T>::quiet_NaN();
  T power = size;
  if (size == T(1)) {
    power = T(1);
  } else if (size == T(0) || size == infinity<T>() || abs(y) == infinity<T>()) {
    power = (size > T(1)) == (y > T(0)) ? infinity<T>() : T(0);
  } else if (size < std::numeric_limits<T>::min()) {
    const T scale = T(1) / std::numeric_limits<T>::epsilon();
    power = pow(size * scale, y) / pow(scale, y);
  } else {
    const TwoParts<T> logarithm = log_in_parts(size);
    const T product = y * logarithm.high;
    const bool in_range = abs(product) < T(2 * std::numeric_limits<T>::max_exponent);
    const TwoParts<T> exponent =
        in_range ? two_product(y, logarithm.high) : TwoParts<T>{product, T(0)};
    power = exp(exponent.high, in_range ? exponent.low + y * logarithm.low : T(0));
  }
  return odd && std::signbit(x) ? -power : power;
}

/// The cosine and the sine of a plain number of radians.
/// Bound: 1.1 ulp up to 1e6; above, of an angle within half an ulp of `x`. NaN for infinities.
/// A long double near more than 10 quarter turns loses up to 6 bits: pi / 2 has three parts.
template <class T>
struct CosineAndSine {
  T cosine, sine;

  explicit CosineAndSine(T x) {
    if (abs(x) > T(0x1p20)) x = std::fmod(x, T(2) * pi<T>());
    // Quarter turns, pi / 2 in three parts: whole numbers up to 2^20 times the first two are exact.
    const T quarters = floor(x * static_cast<T>(2 / pi_digits) + T(0.5));
    const T most = x - quarters * static_cast<T>(0x1.921fb544p+0L);
    const TwoParts<T> rest = two_sum(most, -quarters * static_cast<T>(0x1.0b4611a6p-34L));
    const T below = rest.low - quarters * static_cast<T>(0x1.3198a2e03707344a4093822p-69L);
    const T angle = rest.high + below;
    const T lost = (rest.high - angle) + below;
    const T square = angle * angle;
    const T small = angle * square * power_series(square, series<T>.sine) + lost;
    const T s = x == T(0) ? x : angle + small;  // -0 stays -0
    const T half = T(0.5) * square;
    const T big = T(1) - half;
    const T c =
        big + (((T(1) - big) - half) +
               (square * square * power_series(square, series<T>.cosine, 1) - angle * lost));
    const T quadrant = quarters - T(4) * floor(quarters / T(4));
    cosine = quadrant == T(0) ? c : quadrant == T(1) ? -s : quadrant == T(2) ? -c : s;
    sine = quadrant == T(0) ? s : quadrant == T(1) ? c : quadrant == T(2) ? -s : -c;
  }
};

/// atan(t) / t - 1 as a function of z = t^2, for |t| up to tan(pi / 8).
/// Source: Moshier's Cephes library, atan.c and atanf.c; wider numbers take Taylor's series.
template <class Real>
[[nodiscard]] Real arc_tangent_rest(const Real& z) {
  using T = Scalar<Real>;
  const auto polynomial = [&z](auto highest, auto... rest) {
    Real sum(static_cast<T>(highest));
    ((sum = sum * z + Real(static_cast<T>(rest))), ...);
    return sum;
  };
  if constexpr (Series<T>::digits <= 24) {
    return z * polynomial(8.05374449538e-2, -1.38776856032e-1, 1.99777106478e-1, -3.33329491539e-1);
  } else if constexpr (Series<T>::digits <= 53) {  // long double may be double
    return z *
           polynomial(-8.750608600031904122785e-1, -1.615753718733365076637e1,
                      -7.500855792314704667340e1, -1.228866684490136173410e2,
                      -6.485021904942025371773e1) /
           polynomial(1.0, 2.485846490142306297962e1, 1.650270098316988542046e2,
                      4.328810604912902668951e2, 4.853903996359136964868e2,
                      1.945506571482613964425e2);
  } else {
    return z * power_series(z, series<T>.arc_tangent);
  }
}

/// The angle of the point (x, y), -pi to pi. Bound: 2.2 ulp; packs of float 2.4.
/// In all cases as std::atan2, but packs give NaN for (0, 0) and for two infinities.
template <class Real>
[[nodiscard]] Real atan2(const Real& y, const Real& x) {
  using T = Scalar<Real>;
  const Real wide_y = abs(y);
  const Real wide_x = abs(x);
  const Mask<Real> steep = wide_y > wide_x;
  const Real wider = select(steep, wide_y, wide_x);
  const Real narrower = select(steep, wide_x, wide_y);
  if constexpr (lanes<Real> == 1) {
    if (narrower == wider && (wider == T(0) || wider == infinity<T>()))
      return atan2(copysign(wider == T(0) ? T(0) : T(1), y), copysign(T(1), x));
  }
  // The scale keeps sums from overflowing and keeps subnormal numbers out of the comparison.
  const Real scale = select(wider > Real(1), Real(T(0.5)), Real(static_cast<T>(0x1p60)));
  const Real wide = wider * scale;
  const Real narrow = narrower * scale;

  // One division: the octant decides what is divided, and atan(t) = pi / 4 +
  // atan((t - 1) / (t + 1)) reduces t to tan(pi / 8).
  const Mask<Real> diagonal = narrow > wide * Real(static_cast<T>(0.41421356237309504880L));
  const Real t = select(diagonal, narrow - wide, narrow) / select(diagonal, narrow + wide, wide);
  const Real angle = t + t * arc_tangent_rest(t * t);

  // pi / 4 in two parts, the lower one by the digits of the number.
  constexpr int digits = std::numeric_limits<T>::digits;
  const T high = static_cast<T>(pi_digits / 4);
  const T low = static_cast<T>(digits == 24   ? -2.18556941e-8L
                               : digits == 53 ? 3.06161699786838302e-17L
                               : digits == 64 ? -1.25413940316708300589e-20L
                                              : 0.0L);
  const auto twice_if_steep = [&](T eighth) {
    return select(diagonal, Real(eighth), select(steep, Real(T(2) * eighth), Real(T(0))));
  };
  const Real in_quarter =
      twice_if_steep(high) + (select(steep, -angle, angle) + twice_if_steep(low));
  const Real in_half = select(x > Real(0), in_quarter, Real(T(4) * high) - in_quarter);
  return copysign(in_half, y);
}

}  // namespace texmap::elementary
