// Two packs used like one: while the first waits for a result, the processor works on the second.
#pragma once
#include <algorithm>

#include "number/kinds/pack.hpp"

namespace texmap {

/// Two values of one kind: two packs, two masks or two sets of integers.
/// Results are those of the two packs, to the last bit; docs/numerics.md says why two are faster.
///
/// @tparam Half  Pack<T, Arch>, its Mask or its UInt
template <class Half>
struct Pack2 {
  Half first, second;
  static constexpr std::size_t in_half = [] {
    if constexpr (requires { Half::size; })
      return Half::size;  // integers; packs and masks have lanes
    return lanes<Half>;
  }();
  static constexpr std::size_t size = 2 * in_half;

  Pack2() = default;
  Pack2(const Half& a, const Half& b) : first(a), second(b) {}
  /// The same number in every lane.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  explicit(!std::is_convertible_v<Number, Half>) Pack2(Number number)
      : first(number), second(number) {}

  /// Not what `if`, `? :` and int need: only words for whoever writes them.
  template <class Plain>
  requires std::is_arithmetic_v<Plain>
  explicit operator Plain() const {
    static_assert(!sizeof(Plain),
                  "a pack of numbers has no single value for `if`, `? :`, int or double: write "
                  "select(mask, a, b), any(mask) and floor(x), or say in the lesson's `about` that "
                  "its code branches: .numbers = Numbers::single");
    return {};
  }
  [[nodiscard]] auto get(std::size_t i) const {
    return i < in_half ? first.get(i) : second.get(i - in_half);
  }

// An operator of two pairs is that of their first and that of their second halves.
#define TEXMAP_OF_HALVES(op)                                  \
  friend auto operator op(const Pack2& a, const Pack2& b) {   \
    return pair_of(a.first op b.first, a.second op b.second); \
  }
  TEXMAP_OF_HALVES(+)
  TEXMAP_OF_HALVES(-)
  TEXMAP_OF_HALVES(*)
  TEXMAP_OF_HALVES(/)
  TEXMAP_OF_HALVES(<)
  TEXMAP_OF_HALVES(<=)
  TEXMAP_OF_HALVES(>)
  TEXMAP_OF_HALVES(>=)
  TEXMAP_OF_HALVES(==)
  TEXMAP_OF_HALVES(&&)
  TEXMAP_OF_HALVES(||)
  TEXMAP_OF_HALVES(^)
  TEXMAP_OF_HALVES(&)
  TEXMAP_OF_HALVES(|)
#undef TEXMAP_OF_HALVES

  friend Pack2 operator-(const Pack2& a) { return {-a.first, -a.second}; }
  friend Pack2 operator!(const Pack2& a) { return {!a.first, !a.second}; }
  friend Pack2 operator~(const Pack2& a) { return {~a.first, ~a.second}; }
  friend Pack2 operator<<(const Pack2& a, int count) {
    return {a.first << count, a.second << count};
  }
  friend Pack2 operator>>(const Pack2& a, int count) {
    return {a.first >> count, a.second >> count};
  }
  friend bool any(const Pack2& a) { return any(a.first || a.second); }
  template <class HalfMask>
  friend Pack2 select(const Pack2<HalfMask>& mask, const Pack2& yes, const Pack2& no) {
    return {select(mask.first, yes.first, no.first), select(mask.second, yes.second, no.second)};
  }
  friend Pack2 max(const Pack2& a, const Pack2& b) {
    return {max(a.first, b.first), max(a.second, b.second)};
  }
  friend Pack2 min(const Pack2& a, const Pack2& b) {
    return {min(a.first, b.first), min(a.second, b.second)};
  }
  friend Pack2 abs(const Pack2& a) { return {abs(a.first), abs(a.second)}; }
  friend Pack2 copysign(const Pack2& a, const Pack2& sign) {
    return {copysign(a.first, sign.first), copysign(a.second, sign.second)};
  }
  friend Pack2 sqrt(const Pack2& a) { return {sqrt(a.first), sqrt(a.second)}; }
  friend Pack2 floor(const Pack2& a) { return {floor(a.first), floor(a.second)}; }
  template <class Function>
  friend Pack2 map_bits(const Pack2& a, const Function& of) {
    return {map_bits(a.first, of), map_bits(a.second, of)};
  }
  friend Pack2 exp(const Pack2& a) { return {exp(a.first), exp(a.second)}; }
  friend Pack2 log1p(const Pack2& a) { return {log1p(a.first), log1p(a.second)}; }
  friend Pack2 atan2(const Pack2& y, const Pack2& x) {
    return {atan2(y.first, x.first), atan2(y.second, x.second)};
  }
  friend Pack2 select_less(const Pack2& a, const Pack2& b, const Pack2& yes, const Pack2& no) {
    return {select_less(a.first, b.first, yes.first, no.first),
            select_less(a.second, b.second, yes.second, no.second)};
  }

  /// value(i) in lane `i`; see PackU32.
  template <class Value>
  [[nodiscard]] static Pack2 from_lanes(Value value) {
    return {Half::from_lanes(value),
            Half::from_lanes([&](std::size_t i) { return value(i + in_half); })};
  }
  /// See PackU32.
  template <class Real>
  [[nodiscard]] static Pack2 from_real(const Real& x) {
    return {Half::from_real(x.first), Half::from_real(x.second)};
  }
  /// See PackU32.
  template <class Real>
  [[nodiscard]] Real to_real() const {
    using HalfReal = decltype(Real::first);
    return {first.template to_real<HalfReal>(), second.template to_real<HalfReal>()};
  }

 private:
  template <class OtherHalf>
  static Pack2<OtherHalf> pair_of(const OtherHalf& a, const OtherHalf& b) {
    return {a, b};
  }
};

template <class Half>
struct NumberTraits<Pack2<Half>> {
  using Scalar = texmap::Scalar<Half>;
  using Mask = Pack2<texmap::Mask<Half>>;
  static constexpr std::size_t lanes = 2 * texmap::lanes<Half>;
  using UInt = Pack2<texmap::UInt<Half>>;

  [[nodiscard]] static std::array<Scalar, lanes> all_lanes(const Pack2<Half>& x) {
    const auto first = texmap::all_lanes(x.first);
    const auto second = texmap::all_lanes(x.second);
    std::array<Scalar, lanes> values;
    std::copy(first.begin(), first.end(), values.begin());
    std::copy(second.begin(), second.end(), values.begin() + first.size());
    return values;
  }
  template <class Value>
  [[nodiscard]] static Pack2<Half> from_lanes(Value value) {
    return {texmap::from_lanes<Half>(value),
            texmap::from_lanes<Half>([&](std::size_t i) { return value(i + lanes / 2); })};
  }
};

}  // namespace texmap
