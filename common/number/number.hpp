// What the course asks of a number: float, double, long double, and packs of them.
#pragma once
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#ifdef __FAST_MATH__
#error "This course measures rounding errors: it cannot be compiled with -ffast-math or -Ofast."
#endif

namespace texmap {

// Of plain numbers. Packs have their own, found by argument-dependent lookup.
using std::abs;
using std::copysign;
using std::floor;
using std::ldexp;
using std::sqrt;

/// Elementary functions of float, double and long double: std's, to 3 ulp, but made of operations
/// that every machine rounds alike, so that pictures do not depend on the C library. Angles are in
/// radians. Source: number/kinds/elementary.hpp, with its bounds.
template <std::floating_point T>
[[nodiscard]] T atan2(T y, std::type_identity_t<T> x);
template <std::floating_point T>
[[nodiscard]] T acos(T x);
template <std::floating_point T>
[[nodiscard]] T asin(T x);
template <std::floating_point T>
[[nodiscard]] T cos(T x);
template <std::floating_point T>
[[nodiscard]] T sin(T x);
template <std::floating_point T>
[[nodiscard]] T tan(T x);
template <std::floating_point T>
[[nodiscard]] T exp(T x);
template <std::floating_point T>
[[nodiscard]] T log1p(T x);
template <std::floating_point T>
[[nodiscard]] T pow(T x, std::type_identity_t<T> exponent);

/// What differs between one number and a pack of numbers, which specializes this.
template <class Real>
struct NumberTraits {
  using Scalar = Real;                     ///< the number in one lane
  using Mask = bool;                       ///< what a comparison gives
  using UInt = std::uint32_t;              ///< an unsigned 32-bit integer in each lane
  static constexpr std::size_t lanes = 1;  ///< how many numbers it holds
};

template <class Real>
using Scalar = typename NumberTraits<Real>::Scalar;
template <class Real>
using Mask = typename NumberTraits<Real>::Mask;
template <class Real>
inline constexpr std::size_t lanes = NumberTraits<Real>::lanes;

/// The digits of pi for every `long double` there is. (libc++ has std::numbers::pi in double.)
inline constexpr long double pi_digits = 3.14159265358979323846264338327950288L;

// Constants are functions, so that no global is initialized before main.

/// Pi to every digit of `Real`.
template <class Real>
[[nodiscard]] inline Real pi() {
  return Real(static_cast<Scalar<Real>>(pi_digits));
}

/// Plus infinity: the distance of a ray that hits nothing.
template <class Real>
[[nodiscard]] inline Real infinity() {
  return Real(std::numeric_limits<Scalar<Real>>::infinity());
}

/// The largest number below 1.
template <class Real>
[[nodiscard]] inline Real below_one() {
  return Real(Scalar<Real>(1) - std::numeric_limits<Scalar<Real>>::epsilon() / Scalar<Real>(2));
}

/// Half the distance from 1 to the next number: the largest relative error of one rounding.
template <class Real>
[[nodiscard]] inline Real unit_roundoff() {
  return Real(std::numeric_limits<Scalar<Real>>::epsilon() / Scalar<Real>(2));
}

/// `yes` where the mask is true, else `no`. Both are computed: a pack cannot branch.
template <class Real>
[[nodiscard]] inline Real select(bool mask, const Real& yes, const Real& no) {
  return mask ? yes : no;
}

/// True when any lane of the mask is.
[[nodiscard]] inline bool any(bool mask) { return mask; }

/// A mask with the same value in all lanes.
template <class Real>
[[nodiscard]] inline Mask<Real> mask_of(bool value) {
  return Real(value ? 1 : 0) > Real(0);
}

/// The number in lane `i` of `x`.
template <class Real>
[[nodiscard]] inline Scalar<Real> lane(const Real& x, std::size_t i) {
  if constexpr (lanes<Real> == 1) {
    return x;
  } else {
    return x.get(i);
  }
}

/// A number with value(i) in lane `i`, for i from 0 to lanes - 1.
template <class Real, class Value>
[[nodiscard]] inline Real from_lanes(Value value) {
  if constexpr (lanes<Real> == 1) {
    return value(std::size_t{0});
  } else {
    return NumberTraits<Real>::from_lanes(value);
  }
}

/// The larger number; a NaN in `a` gives `b`.
template <class Real>
[[nodiscard]] inline Real max(const Real& a, const Real& b) {
  return select(a > b, a, b);
}

/// The smaller number; a NaN in `a` gives `b`.
template <class Real>
[[nodiscard]] inline Real min(const Real& a, const Real& b) {
  return select(a < b, a, b);
}

/// `x` limited to [low, high]; a NaN becomes `low`.
template <class Real>
[[nodiscard]] inline Real clamp(const Real& x, const Real& low, const Real& high) {
  return min(max(x, low), high);
}

template <class Real>
[[nodiscard]] inline Real square(const Real& x) {
  return x * x;
}

/// `x` to the power of a plain number.
template <class Real>
[[nodiscard]] inline Real power(const Real& x, Scalar<Real> exponent) {
  return from_lanes<Real>([&](std::size_t i) { return pow(lane(x, i), exponent); });
}

/// The numbers of all lanes.
template <class Real>
[[nodiscard]] inline std::array<Scalar<Real>, lanes<Real>> all_lanes(const Real& x) {
  if constexpr (lanes<Real> == 1) {
    return {x};
  } else {
    return NumberTraits<Real>::all_lanes(x);
  }
}

}  // namespace texmap
