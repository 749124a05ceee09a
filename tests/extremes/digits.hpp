// How far a number is from one of 50 digits; vectors of such numbers; inputs for each lane, and as
// text that can be pasted into a test.
#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include "math/vec3.hpp"
#include "number/number.hpp"
#include "scene/ray.hpp"
#include "support/dice.hpp"
#include "support/lane_of.hpp"
#include "support/many_digits.hpp"

namespace texmap::test {}

namespace texmap::extremes {

using namespace test;

/// The circle constant in as many digits.
template <class Exact>
[[nodiscard]] const Exact& circle() {
  static const Exact value = acos(Exact(-1));
  return value;
}

/// The same vector with more digits; nothing is rounded.
template <class T>
[[nodiscard]] Vec3<Digits50> exactly(const Vec3<T>& p) {
  return {Digits50(p.x), Digits50(p.y), Digits50(p.z)};
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

/// How far `got` is from the exact value, in `unit`s; infinity for what is no finite number.
template <class T>
[[nodiscard]] double units_off(T got, const Digits50& exact, const Digits50& unit) {
  if (!std::isfinite(got)) return std::numeric_limits<double>::infinity();
  return static_cast<double>(abs(Digits50(got) - exact) / unit);
}
/// The same in units in the last place of the exact value.
template <class T>
[[nodiscard]] double ulps_off(T got, const Digits50& exact) {
  return units_off(got, exact, ulp_at<T>(exact));
}
/// The same in unit roundoffs of the exact value, where zero has to come out as zero.
template <class T>
[[nodiscard]] double relative_off(T got, const Digits50& exact) {
  if (exact == 0) return got == 0 ? 0 : 1e30;
  return units_off(got, exact, abs(exact) * roundoff<T>());
}
/// The length of the difference of two vectors, in unit roundoffs.
template <class T>
[[nodiscard]] double length_off(const Vec3<T>& got, const Vec3<Digits50>& exact) {
  return static_cast<double>(length(exactly(got) - exact) / roundoff<T>());
}

/// `get(i)` of all lanes as one thing of packs: a number, a vector, a ray, or an array of these.
///
/// @param one  what one lane's is like
template <class Real, class Get>
[[nodiscard]] Real packed(const Get& get, const Scalar<Real>& /*one*/) {
  return from_lanes<Real>(get);
}
template <class Real, class Get, template <class> class Thing, class T>
requires HasParts<Thing<T>>
[[nodiscard]] Thing<Real> packed(const Get& get, const Thing<T>& one) {
  const auto part = [&]<std::size_t k>() {
    return packed<Real>([&](std::size_t i) { return std::get<k>(parts_of(get(i))); },
                        std::get<k>(parts_of(one)));
  };
  return [&]<std::size_t... k>(std::index_sequence<k...>) {
    return Thing<Real>{part.template operator()<k>()...};
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(parts_of(one))>>());
}
template <class Real, class Get, class One, std::size_t count>
[[nodiscard]] auto packed(const Get& get, const std::array<One, count>& one) {
  std::array<decltype(packed<Real>([&](std::size_t i) { return get(i)[0]; }, one[0])), count> all;
  for (std::size_t k = 0; k < count; ++k)
    all[k] = packed<Real>([&](std::size_t i) { return get(i)[k]; }, one[k]);
  return all;
}

/// One drawn thing for each lane.
template <class Real, class Draw>
[[nodiscard]] auto drawn(const Draw& draw) {
  std::array<decltype(draw()), lanes<Real>> each;
  for (auto& one : each) one = draw();
  return each;
}
/// With every digit; the numbers of a vector or a ray in braces.
template <class Thing>
[[nodiscard]] std::string described(const Thing& x) {
  std::ostringstream text;
  if constexpr (HasParts<Thing>) {
    const char* before = "{";
    const auto show = [&](const auto& part) {
      text << before << described(part);
      before = ", ";
    };
    std::apply([&](const auto&... part) { (show(part), ...); }, parts_of(x));
    text << "}";
  } else {
    text.precision(std::numeric_limits<Thing>::max_digits10);
    text << x;
  }
  return text.str();
}
template <class One, std::size_t count>
[[nodiscard]] std::string described(const std::array<One, count>& all) {
  std::string text;
  for (const One& one : all) text += (text.empty() ? "" : " ") + described(one);
  return text;
}

}  // namespace texmap::extremes
