// How far a number is from one of 50 digits, and vectors of such numbers.
#pragma once
#include <array>
#include <cmath>
#include <limits>

#include "dice.hpp"
#include "many_digits.hpp"
#include "number.hpp"
#include "vec3.hpp"

namespace texmap::extremes {

/// The circle constant in as many digits.
template <class Exact>
[[nodiscard]] const Exact& circle() {
  static const Exact value = acos(Exact(-1));
  return value;
}

/// The same vector with more digits; nothing is rounded.
template <class Exact, class T>
[[nodiscard]] Vec3<Exact> exactly(const Vec3<T>& p) {
  return {Exact(p.x), Exact(p.y), Exact(p.z)};
}

/// Half the distance from 1 to the next T.
template <class T>
[[nodiscard]] const Digits50& roundoff() {
  static const Digits50 value = Digits50(std::numeric_limits<T>::epsilon()) / 2;
  return value;
}

/// The distance between neighbouring numbers of type T at `exact`.
template <class T>
[[nodiscard]] Digits50 ulp_at(const Digits50& exact) {
  using Limits = std::numeric_limits<T>;
  int exponent = Limits::min_exponent;
  if (exact != 0) frexp(exact, &exponent);
  if (exponent < Limits::min_exponent) exponent = Limits::min_exponent;
  return ldexp(Digits50(1), exponent - Limits::digits);
}

/// How far `got` is from the exact value, in units in the last place of the exact value; infinity for a NaN.
template <class T>
[[nodiscard]] double ulps_off(T got, const Digits50& exact) {
  if (!std::isfinite(got)) return std::numeric_limits<double>::infinity();
  return static_cast<double>(abs(Digits50(got) - exact) / ulp_at<T>(exact));
}

/// How far `got` is from the exact value, in `unit`s; infinity for what is no finite number.
template <class T>
[[nodiscard]] double units_off(T got, const Digits50& exact, const Digits50& unit) {
  if (!std::isfinite(got)) return std::numeric_limits<double>::infinity();
  return static_cast<double>(abs(Digits50(got) - exact) / unit);
}

/// One vector for each lane, as one vector.
template <class Real, class Each>
[[nodiscard]] Vec3<Real> gathered(const Each& each) {
  return {from_lanes<Real>([&](std::size_t i) { return each[i].x; }),
          from_lanes<Real>([&](std::size_t i) { return each[i].y; }),
          from_lanes<Real>([&](std::size_t i) { return each[i].z; })};
}

/// One number for each lane, as one number.
template <class Real, class Each>
[[nodiscard]] Real gathered_numbers(const Each& each) {
  return from_lanes<Real>([&](std::size_t i) { return each[i]; });
}

/// One drawn thing for each lane.
template <class Real, class Draw>
[[nodiscard]] auto drawn(const Draw& draw) {
  std::array<decltype(draw()), lanes<Real>> each;
  for (auto& one : each) one = draw();
  return each;
}

/// A direction in each lane.
template <class Real>
[[nodiscard]] Vec3<Real> drawn_direction(Dice& dice) {
  return gathered<Real>(drawn<Real>([&] { return rounded<Scalar<Real>>(dice.direction()); }));
}

template <class Real>
[[nodiscard]] Vec3<Scalar<Real>> lane_of(const Vec3<Real>& p, std::size_t i) {
  return {lane(p.x, i), lane(p.y, i), lane(p.z, i)};
}

}  // namespace texmap::extremes
