// Unsigned 32-bit integers, one for each lane of a number: what hashes and samplers compute with.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "number.hpp"
#include "pack.hpp"

namespace texmap {

#if defined(__GNUC__)
/// The compiler's own vector of `Count` numbers.
template <class Number, std::size_t Count>
struct VectorOf {
  // NOLINTNEXTLINE(modernize-use-using): GCC 12 ignores the attribute of a dependent alias
  typedef Number Type __attribute__((vector_size(sizeof(Number) * Count)));
};
#endif

/// `Count` unsigned 32-bit integers that are worked on at once, each modulo 2^32.
///
/// GCC and Clang have such vectors in the language, for any power of two and without one intrinsic; other compilers get an
/// array and what they make of its loops. xsimd's integers do not serve: its release 8.1 multiplies them one by one on SSE2,
/// and it has no half register for the lanes of a pack of double. Shifts are by the same count, 0 to 31, in all lanes.
template <std::size_t Count>
class LaneBits {
 public:
  static constexpr std::size_t size = Count;

  LaneBits() = default;
  /// The same integer in every lane.
  LaneBits(std::uint32_t value) {  // NOLINT(google-explicit-constructor): constants and scalars mix with lanes
#if defined(__GNUC__)
    values_ = value - Vector{};
#else
    for (std::size_t i = 0; i < stored; ++i) values_.lanes[i] = value;
#endif
  }

  /// Lane `i` holds value(i), for i from 0 to Count - 1.
  template <class Value>
  [[nodiscard]] static LaneBits from_lanes(Value value) {
    Lanes lanes{};
    for (std::size_t i = 0; i < Count; ++i) lanes.lanes[i] = value(i);
    return LaneBits(std::bit_cast<Vector>(lanes), 0);
  }
  [[nodiscard]] std::uint32_t get(std::size_t i) const { return std::bit_cast<Lanes>(values_).lanes[i]; }

#if defined(__GNUC__)
  friend LaneBits operator+(const LaneBits& a, const LaneBits& b) { return {a.values_ + b.values_, 0}; }
  friend LaneBits operator-(const LaneBits& a, const LaneBits& b) { return {a.values_ - b.values_, 0}; }
  friend LaneBits operator*(const LaneBits& a, const LaneBits& b) { return {a.values_ * b.values_, 0}; }
  friend LaneBits operator^(const LaneBits& a, const LaneBits& b) { return {a.values_ ^ b.values_, 0}; }
  friend LaneBits operator&(const LaneBits& a, const LaneBits& b) { return {a.values_ & b.values_, 0}; }
  friend LaneBits operator|(const LaneBits& a, const LaneBits& b) { return {a.values_ | b.values_, 0}; }
  friend LaneBits operator~(const LaneBits& a) { return {~a.values_, 0}; }
  friend LaneBits operator<<(const LaneBits& a, int count) { return {a.values_ << count, 0}; }
  friend LaneBits operator>>(const LaneBits& a, int count) { return {a.values_ >> count, 0}; }

  /// `yes` in the lanes where a < b, else `no`.
  friend LaneBits select_less(const LaneBits& a, const LaneBits& b, const LaneBits& yes, const LaneBits& no) {
    return {a.values_ < b.values_ ? yes.values_ : no.values_, 0};
  }
#else
  friend LaneBits operator+(const LaneBits& a, const LaneBits& b) {
    return each([&](auto i) { return a[i] + b[i]; });
  }
  friend LaneBits operator-(const LaneBits& a, const LaneBits& b) {
    return each([&](auto i) { return a[i] - b[i]; });
  }
  friend LaneBits operator*(const LaneBits& a, const LaneBits& b) {
    return each([&](auto i) { return a[i] * b[i]; });
  }
  friend LaneBits operator^(const LaneBits& a, const LaneBits& b) {
    return each([&](auto i) { return a[i] ^ b[i]; });
  }
  friend LaneBits operator&(const LaneBits& a, const LaneBits& b) {
    return each([&](auto i) { return a[i] & b[i]; });
  }
  friend LaneBits operator|(const LaneBits& a, const LaneBits& b) {
    return each([&](auto i) { return a[i] | b[i]; });
  }
  friend LaneBits operator~(const LaneBits& a) {
    return each([&](auto i) { return ~a[i]; });
  }
  friend LaneBits operator<<(const LaneBits& a, int count) {
    return each([&](auto i) { return a[i] << count; });
  }
  friend LaneBits operator>>(const LaneBits& a, int count) {
    return each([&](auto i) { return a[i] >> count; });
  }

  /// `yes` in the lanes where a < b, else `no`.
  friend LaneBits select_less(const LaneBits& a, const LaneBits& b, const LaneBits& yes, const LaneBits& no) {
    return each([&](auto i) { return a[i] < b[i] ? yes[i] : no[i]; });
  }
#endif

  /// The whole numbers of a pack. Domain: 0 to 2^31 - 1; fractions are cut off.
  template <class Real>
  [[nodiscard]] static LaneBits from_real(const Real& x) {
#if defined(__GNUC__)
    if constexpr (stored == Count) {
      using Signed = typename VectorOf<std::int32_t, Count>::Type;
      using Numbers = typename VectorOf<Scalar<Real>, Count>::Type;
      return {std::bit_cast<Vector>(__builtin_convertvector(std::bit_cast<Numbers>(x.batch()), Signed)), 0};
    }
#endif
    const auto numbers = all_lanes(x);
    return from_lanes([&](std::size_t i) { return static_cast<std::uint32_t>(numbers[i]); });
  }
  /// The lanes as a pack of as many numbers. Exact. Domain: values below 2^24, or below 2^31 for packs of double.
  template <class Real>
  [[nodiscard]] Real to_real() const {
#if defined(__GNUC__)
    if constexpr (stored == Count) {
      using Signed = typename VectorOf<std::int32_t, Count>::Type;  // machines convert signed integers fastest
      using Numbers = typename VectorOf<Scalar<Real>, Count>::Type;
      const Numbers numbers = __builtin_convertvector(std::bit_cast<Signed>(values_), Numbers);
      return Real(std::bit_cast<typename Real::Batch>(numbers));
    }
#endif
    const auto lanes = std::bit_cast<Lanes>(values_);
    return texmap::from_lanes<Real>([&](std::size_t i) { return static_cast<Scalar<Real>>(lanes.lanes[i]); });
  }

 private:
  static constexpr std::size_t stored = Count < 4 ? 4 : Count;  // two lanes use half of a register of four
  struct Lanes {
    alignas(4 * stored) std::uint32_t lanes[stored];
  };
#if defined(__GNUC__)
  using Vector = typename VectorOf<std::uint32_t, stored>::Type;
#else
  using Vector = Lanes;
  std::uint32_t operator[](std::size_t i) const { return values_.lanes[i]; }
  template <class Value>
  static LaneBits each(Value value) {
    LaneBits result;
    for (std::size_t i = 0; i < stored; ++i) result.values_.lanes[i] = value(i);
    return result;
  }
#endif

  LaneBits(const Vector& values, int) : values_(values) {}

  Vector values_{};
};

/// What Bits<Real> is.
template <class Real>
struct BitsOf {
  using Type = std::conditional_t<lanes<Real> == 1, std::uint32_t, LaneBits<lanes<Real>>>;
};

/// Unsigned 32-bit integers, one for each lane of Real: a plain std::uint32_t for plain numbers.
template <class Real>
using Bits = typename BitsOf<Real>::Type;

/// `yes` where a < b, else `no`.
[[nodiscard]] inline std::uint32_t select_less(std::uint32_t a, std::uint32_t b, std::uint32_t yes, std::uint32_t no) {
  return a < b ? yes : no;
}

/// Integers whose lane `i` is `value(i)`, for i from 0 to lanes - 1.
template <class Real, class Value>
[[nodiscard]] inline Bits<Real> bits_from_lanes(Value value) {
  if constexpr (lanes<Real> == 1) {
    return value(std::size_t{0});
  } else {
    return Bits<Real>::from_lanes(value);
  }
}

/// The integer in lane `i` of `bits`.
template <class Real>
[[nodiscard]] inline std::uint32_t lane_of(const Bits<Real>& bits, std::size_t i) {
  if constexpr (lanes<Real> == 1) {
    return bits;
  } else {
    return bits.get(i);
  }
}

/// Integers as numbers, without an error. Domain: below 2^24, the integers that float has.
template <class Real>
[[nodiscard]] inline Real real_from_bits(const Bits<Real>& bits) {
  if constexpr (lanes<Real> == 1) {
    return static_cast<Real>(bits);
  } else {
    return bits.template to_real<Real>();
  }
}

/// The whole numbers of all lanes as integers. Domain: 0 to 2^31 - 1; fractions are cut off.
template <class Real>
[[nodiscard]] inline Bits<Real> bits_from_real(const Real& x) {
  if constexpr (lanes<Real> == 1) {
    return static_cast<std::uint32_t>(x);
  } else {
    return Bits<Real>::from_real(x);
  }
}

/// The upper 24 bits as a fraction: the same number for every Real, exact in all of them.
///
/// @return  in [0, 1), a multiple of 2^-24; the lower 8 bits are dropped
template <class Real>
[[nodiscard]] inline Real unit_interval(const Bits<Real>& bits) {
  return real_from_bits<Real>(bits >> 8) * Real(0x1p-24F);
}

}  // namespace texmap
