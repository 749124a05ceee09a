// Two packs that behave like one: while the first waits for a result, the second has work to do.
#pragma once
#include "bits.hpp"

namespace texmap {

/// Two values of the same kind, worked on side by side: two packs, their two masks, or their two sets of integers.
///
/// A path of light is a long chain of operations, each of which waits 4 to 20 cycles for the one before. A machine looks some
/// 500 operations ahead for others to do meanwhile; one path is longer than that. Two paths, operation by operation in turn,
/// wait for each other: what is known once (the scene, the camera) is made ready once for both, too. Results are those of the
/// two packs by themselves, to the last bit.
///
/// @tparam Half  Pack<T, Arch>, its Mask, or its Bits
template <class Half>
struct Paired {
  Half first, second;
  static constexpr std::size_t in_half = [] {
    if constexpr (requires { Half::size; }) return Half::size;  // integers; packs and masks have their number's lanes
    return lanes<Half>;
  }();
  static constexpr std::size_t size = 2 * in_half;

  Paired() = default;
  Paired(const Half& a, const Half& b) : first(a), second(b) {}
  /// The same number in every lane.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  explicit(!std::is_convertible_v<Number, Half>) Paired(Number number) : first(number), second(number) {}

  [[nodiscard]] auto get(std::size_t i) const { return i < in_half ? first.get(i) : second.get(i - in_half); }

  // Arithmetic, on numbers and integers.
  friend Paired operator+(const Paired& a, const Paired& b) { return {a.first + b.first, a.second + b.second}; }
  friend Paired operator-(const Paired& a, const Paired& b) { return {a.first - b.first, a.second - b.second}; }
  friend Paired operator*(const Paired& a, const Paired& b) { return {a.first * b.first, a.second * b.second}; }
  friend Paired operator/(const Paired& a, const Paired& b) { return {a.first / b.first, a.second / b.second}; }
  friend Paired operator-(const Paired& a) { return {-a.first, -a.second}; }

  friend auto operator<(const Paired& a, const Paired& b) { return masks(a.first < b.first, a.second < b.second); }
  friend auto operator<=(const Paired& a, const Paired& b) { return masks(a.first <= b.first, a.second <= b.second); }
  friend auto operator>(const Paired& a, const Paired& b) { return masks(a.first > b.first, a.second > b.second); }
  friend auto operator>=(const Paired& a, const Paired& b) { return masks(a.first >= b.first, a.second >= b.second); }
  friend auto operator==(const Paired& a, const Paired& b) { return masks(a.first == b.first, a.second == b.second); }

  template <class HalfMask>
  friend Paired select(const Paired<HalfMask>& mask, const Paired& yes, const Paired& no) {
    return {select(mask.first, yes.first, no.first), select(mask.second, yes.second, no.second)};
  }
  friend Paired larger(const Paired& a, const Paired& b) { return {larger(a.first, b.first), larger(a.second, b.second)}; }
  friend Paired smaller(const Paired& a, const Paired& b) { return {smaller(a.first, b.first), smaller(a.second, b.second)}; }
  friend Paired abs(const Paired& a) { return {abs(a.first), abs(a.second)}; }
  friend Paired sqrt(const Paired& a) { return {sqrt(a.first), sqrt(a.second)}; }
  friend Paired floor(const Paired& a) { return {floor(a.first), floor(a.second)}; }
  friend Paired exp(const Paired& a) { return {exp(a.first), exp(a.second)}; }
  friend Paired log1p(const Paired& a) { return {log1p(a.first), log1p(a.second)}; }
  friend Paired atan2(const Paired& y, const Paired& x) { return {atan2(y.first, x.first), atan2(y.second, x.second)}; }

  // Masks.
  friend Paired operator&&(const Paired& a, const Paired& b) { return {a.first && b.first, a.second && b.second}; }
  friend Paired operator||(const Paired& a, const Paired& b) { return {a.first || b.first, a.second || b.second}; }
  friend Paired operator!(const Paired& a) { return {!a.first, !a.second}; }
  friend bool any(const Paired& a) { return any(a.first || a.second); }

  // Bits.
  friend Paired operator^(const Paired& a, const Paired& b) { return {a.first ^ b.first, a.second ^ b.second}; }
  friend Paired operator&(const Paired& a, const Paired& b) { return {a.first & b.first, a.second & b.second}; }
  friend Paired operator|(const Paired& a, const Paired& b) { return {a.first | b.first, a.second | b.second}; }
  friend Paired operator~(const Paired& a) { return {~a.first, ~a.second}; }
  friend Paired operator<<(const Paired& a, int count) { return {a.first << count, a.second << count}; }
  friend Paired operator>>(const Paired& a, int count) { return {a.first >> count, a.second >> count}; }
  friend Paired select_less(const Paired& a, const Paired& b, const Paired& yes, const Paired& no) {
    return {select_less(a.first, b.first, yes.first, no.first), select_less(a.second, b.second, yes.second, no.second)};
  }

  /// Lane `i` holds value(i); see LaneBits.
  template <class Value>
  [[nodiscard]] static Paired from_lanes(Value value) {
    return {Half::from_lanes(value), Half::from_lanes([&](std::size_t i) { return value(i + in_half); })};
  }
  /// See LaneBits.
  template <class Real>
  [[nodiscard]] static Paired from_real(const Real& x) {
    return {Half::from_real(x.first), Half::from_real(x.second)};
  }
  /// See LaneBits.
  template <class Real>
  [[nodiscard]] Real to_real() const {
    using HalfReal = decltype(Real::first);
    return {first.template to_real<HalfReal>(), second.template to_real<HalfReal>()};
  }

 private:
  template <class HalfMask>
  static Paired<HalfMask> masks(const HalfMask& a, const HalfMask& b) {
    return {a, b};
  }
};

template <class Half>
struct NumberTraits<Paired<Half>> {
  using Scalar = texmap::Scalar<Half>;
  using Mask = Paired<texmap::Mask<Half>>;
  static constexpr std::size_t lanes = 2 * texmap::lanes<Half>;

  [[nodiscard]] static std::array<Scalar, lanes> all_lanes(const Paired<Half>& x) {
    const auto first = texmap::all_lanes(x.first);
    const auto second = texmap::all_lanes(x.second);
    std::array<Scalar, lanes> values;
    std::copy(first.begin(), first.end(), values.begin());
    std::copy(second.begin(), second.end(), values.begin() + first.size());
    return values;
  }
  template <class Value>
  [[nodiscard]] static Paired<Half> from_lanes(Value value) {
    return {texmap::from_lanes<Half>(value), texmap::from_lanes<Half>([&](std::size_t i) { return value(i + lanes / 2); })};
  }
};

template <class Half>
struct BitsOf<Paired<Half>> {
  using Type = Paired<Bits<Half>>;
};

}  // namespace texmap
