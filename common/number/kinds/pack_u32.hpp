// Unsigned 32-bit integers in packs, one for each lane of a number.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>

#include "number/uint.hpp"

namespace texmap {

// Without the compiler's vector types, or to test what other compilers build: arrays.
#if defined(__GNUC__) && !defined(TEXMAP_NO_VECTOR_TYPES)
#define TEXMAP_VECTOR_TYPES
#endif

#ifdef TEXMAP_VECTOR_TYPES
/// The compiler's own vector type of `Count` numbers.
template <class Number, std::size_t Count>
struct VectorOf {
  // NOLINTNEXTLINE(modernize-use-using): GCC 12 ignores the attribute of a dependent alias
  typedef Number Type __attribute__((vector_size(sizeof(Number) * Count)));
};
#endif

/// `Count` unsigned 32-bit integers, each modulo 2^32; shifts by 0 to 31, the same in all lanes.
/// They are GCC's and Clang's vector types, for other compilers arrays.
template <std::size_t Count>
class PackU32 {
 public:
  static constexpr std::size_t size = Count;

  PackU32() = default;
  /// The same integer in every lane.
  PackU32(std::uint32_t
              value) {  // NOLINT(google-explicit-constructor): constants and scalars mix with lanes
#ifdef TEXMAP_VECTOR_TYPES
    values_ = value - Vector{};
#else
    for (std::size_t i = 0; i < stored; ++i) values_.lanes[i] = value;
#endif
  }

  /// value(i) in lane `i`, for i from 0 to Count - 1.
  template <class Value>
  [[nodiscard]] static PackU32 from_lanes(Value value) {
    Lanes lanes{};
    for (std::size_t i = 0; i < Count; ++i) lanes.lanes[i] = value(i);
    return PackU32(std::bit_cast<Vector>(lanes), 0);
  }
  [[nodiscard]] std::uint32_t get(std::size_t i) const {
    return std::bit_cast<Lanes>(values_).lanes[i];
  }

#ifdef TEXMAP_VECTOR_TYPES
#define TEXMAP_OF_LANES(op)                                        \
  friend PackU32 operator op(const PackU32& a, const PackU32& b) { \
    return {a.values_ op b.values_, 0};                            \
  }
  friend PackU32 operator~(const PackU32& a) { return {~a.values_, 0}; }
  friend PackU32 operator<<(const PackU32& a, int count) { return {a.values_ << count, 0}; }
  friend PackU32 operator>>(const PackU32& a, int count) { return {a.values_ >> count, 0}; }

  /// `yes` in the lanes where a < b, else `no`.
  friend PackU32 select_less(const PackU32& a, const PackU32& b, const PackU32& yes,
                             const PackU32& no) {
    return {a.values_ < b.values_ ? yes.values_ : no.values_, 0};
  }
#else
#define TEXMAP_OF_LANES(op)                                        \
  friend PackU32 operator op(const PackU32& a, const PackU32& b) { \
    return each([&](auto i) { return a[i] op b[i]; });             \
  }
  friend PackU32 operator~(const PackU32& a) {
    return each([&](auto i) { return ~a[i]; });
  }
  friend PackU32 operator<<(const PackU32& a, int count) {
    return each([&](auto i) { return a[i] << count; });
  }
  friend PackU32 operator>>(const PackU32& a, int count) {
    return each([&](auto i) { return a[i] >> count; });
  }

  /// `yes` in the lanes where a < b, else `no`.
  friend PackU32 select_less(const PackU32& a, const PackU32& b, const PackU32& yes,
                             const PackU32& no) {
    return each([&](auto i) { return a[i] < b[i] ? yes[i] : no[i]; });
  }
#endif
  TEXMAP_OF_LANES(+)
  TEXMAP_OF_LANES(-)
  TEXMAP_OF_LANES(*)
  TEXMAP_OF_LANES(^)
  TEXMAP_OF_LANES(&)
  TEXMAP_OF_LANES(|)
#undef TEXMAP_OF_LANES

  /// The numbers of a pack as integers, cut off. Domain: 0 to 2^31 - 1.
  template <class Real>
  [[nodiscard]] static PackU32 from_real(const Real& x) {
#ifdef TEXMAP_VECTOR_TYPES
    if constexpr (stored == Count) {
      using Signed = typename VectorOf<std::int32_t, Count>::Type;
      using Lane = typename VectorOf<Scalar<Real>, Count>::Type;
      return {
          std::bit_cast<Vector>(__builtin_convertvector(std::bit_cast<Lane>(x.batch()), Signed)),
          0};
    }
#endif
    const auto numbers = all_lanes(x);
    return from_lanes([&](std::size_t i) { return static_cast<std::uint32_t>(numbers[i]); });
  }
  /// The lanes as a pack of numbers, exact. Domain: below 2^24, for packs of double below 2^31.
  template <class Real>
  [[nodiscard]] Real to_real() const {
#ifdef TEXMAP_VECTOR_TYPES
    if constexpr (stored == Count) {
      // Conversion from signed integers has an instruction; from unsigned ones it takes several.
      using Signed = typename VectorOf<std::int32_t, Count>::Type;
      using Lane = typename VectorOf<Scalar<Real>, Count>::Type;
      const Lane numbers = __builtin_convertvector(std::bit_cast<Signed>(values_), Lane);
      return Real(std::bit_cast<typename Real::Batch>(numbers));
    }
#endif
    const auto lanes = std::bit_cast<Lanes>(values_);
    return texmap::from_lanes<Real>(
        [&](std::size_t i) { return static_cast<Scalar<Real>>(lanes.lanes[i]); });
  }

 private:
  static constexpr std::size_t stored = Count < 4 ? 4 : Count;  // at least a register of four
  struct Lanes {
    alignas(4 * stored) std::uint32_t lanes[stored];
  };
#ifdef TEXMAP_VECTOR_TYPES
  using Vector = typename VectorOf<std::uint32_t, stored>::Type;
#else
  using Vector = Lanes;
  std::uint32_t operator[](std::size_t i) const { return values_.lanes[i]; }
  template <class Value>
  static PackU32 each(Value value) {
    PackU32 result;
    for (std::size_t i = 0; i < stored; ++i) result.values_.lanes[i] = value(i);
    return result;
  }
#endif

  PackU32(const Vector& values, int) : values_(values) {}

  Vector values_{};
};

}  // namespace texmap
