// What the course asks of a number. float, double and long double have it all; packs of them learn it in pack.hpp.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace texmap {

// Unqualified calls find these for plain numbers and, by argument-dependent lookup, the pack's or the reference number's own.
using std::abs;
using std::atan2;
using std::cos;
using std::exp;
using std::floor;
using std::ldexp;
using std::log1p;
using std::pow;
using std::sin;
using std::sqrt;

/// What differs between one number and a pack of numbers.
template <class Real>
struct NumberTraits {
  using Scalar = Real;                     ///< the number in one lane
  using Mask = bool;                       ///< what a comparison gives
  static constexpr std::size_t lanes = 1;  ///< numbers worked on at once
};

template <class Real>
using Scalar = typename NumberTraits<Real>::Scalar;
template <class Real>
using Mask = typename NumberTraits<Real>::Mask;
template <class Real>
inline constexpr std::size_t lanes = NumberTraits<Real>::lanes;

// Constants are functions: a variable would be made when the program starts, and one for wide packs with instructions that the
// machine may not have.

/// The circle constant to every digit of `Real`.
template <class Real>
[[nodiscard]] inline Real pi() {
  return Real(std::numbers::pi_v<Scalar<Real>>);
}

/// Plus infinity: the distance of a ray that hits nothing.
template <class Real>
[[nodiscard]] inline Real infinity() {
  return Real(std::numeric_limits<Scalar<Real>>::infinity());
}

/// The largest number below one: the end of the half-open range [0, 1) of texture coordinates.
template <class Real>
[[nodiscard]] inline Real below_one() {
  return Real(Scalar<Real>(1) - std::numeric_limits<Scalar<Real>>::epsilon() / Scalar<Real>(2));
}

/// Half the distance from 1 to the next number: the largest relative error of one rounded operation.
template <class Real>
[[nodiscard]] inline Real unit_roundoff() {
  return Real(std::numeric_limits<Scalar<Real>>::epsilon() / Scalar<Real>(2));
}

/// `yes` where the mask is true, else `no`. Both sides are computed: a pack cannot branch.
template <class Real>
[[nodiscard]] inline Real select(bool mask, const Real& yes, const Real& no) {
  return mask ? yes : no;
}

/// True when any lane of the mask is.
[[nodiscard]] inline bool any(bool mask) { return mask; }

/// The number in lane `i` of `x`.
template <class Real>
[[nodiscard]] inline Scalar<Real> lane(const Real& x, std::size_t i) {
  if constexpr (lanes<Real> == 1) {
    return x;
  } else {
    return x.get(i);
  }
}

/// A number whose lane `i` is `value(i)`, for i from 0 to lanes - 1.
template <class Real, class Value>
[[nodiscard]] inline Real from_lanes(Value value) {
  if constexpr (lanes<Real> == 1) {
    return value(std::size_t{0});
  } else {
    return NumberTraits<Real>::from_lanes(value);
  }
}

/// The larger of two numbers; a NaN in `a` gives `b`.
template <class Real>
[[nodiscard]] inline Real larger(const Real& a, const Real& b) {
  return select(a > b, a, b);
}

/// The smaller of two numbers; a NaN in `a` gives `b`.
template <class Real>
[[nodiscard]] inline Real smaller(const Real& a, const Real& b) {
  return select(a < b, a, b);
}

/// `x` brought into [low, high]; a NaN becomes `low`.
template <class Real>
[[nodiscard]] inline Real clamp(const Real& x, const Real& low, const Real& high) {
  return smaller(larger(x, low), high);
}

/// x * x.
template <class Real>
[[nodiscard]] inline Real square(const Real& x) {
  return x * x;
}

/// `x` to the power of a plain number, as std::pow has it.
template <class Real>
[[nodiscard]] inline Real power(const Real& x, Scalar<Real> exponent) {
  return from_lanes<Real>([&](std::size_t i) { return pow(lane(x, i), exponent); });
}

/// The numbers of all lanes at once: asking lane by lane would put the pack into memory each time.
template <class Real>
[[nodiscard]] inline std::array<Scalar<Real>, lanes<Real>> all_lanes(const Real& x) {
  if constexpr (lanes<Real> == 1) {
    return {x};
  } else {
    return NumberTraits<Real>::all_lanes(x);
  }
}

/// The entry of a table at a place given by whole numbers; each lane of a pack reads its own.
///
/// @param table        callable with two int, gives three plain numbers: a color's channels
/// @param column, row  whole numbers that the table knows
template <class Real, class Table>
[[nodiscard]] inline std::array<Real, 3> look_up(const Table& table, const Real& column, const Real& row) {
  const auto columns = all_lanes(column);
  const auto rows = all_lanes(row);
  std::array<std::array<Scalar<Real>, lanes<Real>>, 3> channels;
  for (std::size_t i = 0; i < lanes<Real>; ++i) {
    const auto entry = table(static_cast<int>(columns[i]), static_cast<int>(rows[i]));
    for (std::size_t k = 0; k < 3; ++k) channels[k][i] = static_cast<Scalar<Real>>(entry[k]);
  }
  const auto packed = [&](std::size_t k) { return from_lanes<Real>([&](std::size_t i) { return channels[k][i]; }); };
  return {packed(0), packed(1), packed(2)};
}

}  // namespace texmap
