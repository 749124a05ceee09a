// What packs are built on: xsimd's batches if CMake found xsimd, else arrays of the same size. Of
// xsimd it takes what rounds once or moves bits, the same in every version: not its functions, not
// its max and min, and floor only where that is one instruction.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#ifdef TEXMAP_HAVE_XSIMD
#include <xsimd/xsimd.hpp>
#endif

namespace texmap::simd {

/// Names the instructions that packs are made of, by the bytes of a register. A name of xsimd's in
/// the type would make argument-dependent look-up find whatever xsimd declares.
template <std::size_t Bytes>
struct Registers {};

#ifdef TEXMAP_HAVE_XSIMD
/// True where a batch is a vector of the machine's.
inline constexpr bool has_machine_vectors = true;

#if XSIMD_WITH_FMA3_AVX2
// The widest instructions that code is compiled for, without those that multiply and add at once:
// they round once, and the pictures would differ.
using Xsimd = std::conditional_t<std::is_same_v<xsimd::default_arch, xsimd::fma3<xsimd::avx2>>,
                                 xsimd::avx2, xsimd::default_arch>;
#else
using Xsimd = xsimd::default_arch;
#endif
template <class T>
using Batch = xsimd::batch<T, Xsimd>;
template <class T>
using BatchBool = xsimd::batch_bool<T, Xsimd>;

template <class T>
[[nodiscard]] bool any(const BatchBool<T>& mask) {
  return xsimd::any(mask);
}
template <class T>
[[nodiscard]] Batch<T> select(const BatchBool<T>& mask, const Batch<T>& yes, const Batch<T>& no) {
  return xsimd::select(mask, yes, no);
}
/// -a. (xsimd 13 subtracts from 0 with AVX-512, and 0 - 0 is +0.)
template <class T>
[[nodiscard]] Batch<T> negate(const Batch<T>& a) {
  return a ^ Batch<T>(T(-0.0));
}
/// `size`, 0 or more, with the sign of `sign`.
template <class T>
[[nodiscard]] Batch<T> with_sign(const Batch<T>& size, const Batch<T>& sign) {
  return size | (sign & Batch<T>(T(-0.0)));
}
template <class T>
[[nodiscard]] Batch<T> abs(const Batch<T>& a) {
  return xsimd::abs(a);
}
/// a / b, rounded in each lane like a single number.
template <class T>
[[nodiscard]] Batch<T> divide(const Batch<T>& a, const Batch<T>& b) {
#ifdef __aarch64__  // xsimd 8 divides floats by Newton's method there
  if constexpr (std::is_same_v<T, float>) return Batch<T>(vdivq_f32(a, b));
#endif
  return a / b;
}
/// The square root, rounded in each lane like a single number's.
template <class T>
[[nodiscard]] Batch<T> sqrt(const Batch<T>& a) {
#ifdef __aarch64__
  if constexpr (std::is_same_v<T, float>) return Batch<T>(vsqrtq_f32(a));
#endif
  return xsimd::sqrt(a);
}
#ifdef __SSE2__  // x86 has an instruction for `a > b ? a : b`, which two would take longer for
#define TEXMAP_X86_PACKS
#define TEXMAP_OF_REGISTERS(T, Register, family, kind)                              \
  inline Batch<T> max(Register a, Register b) { return family##_max_##kind(a, b); } \
  inline Batch<T> min(Register a, Register b) { return family##_min_##kind(a, b); }
#ifdef __AVX512F__
TEXMAP_OF_REGISTERS(float, __m512, _mm512, ps)
TEXMAP_OF_REGISTERS(double, __m512d, _mm512, pd)
#elif defined(__AVX__)
TEXMAP_OF_REGISTERS(float, __m256, _mm256, ps)
TEXMAP_OF_REGISTERS(double, __m256d, _mm256, pd)
#else
TEXMAP_OF_REGISTERS(float, __m128, _mm, ps)
TEXMAP_OF_REGISTERS(double, __m128d, _mm, pd)
#endif
#undef TEXMAP_OF_REGISTERS
#endif
/// The largest whole number that is not above `a`.
template <class T>
[[nodiscard]] Batch<T> floor(const Batch<T>& a) {
#ifdef __SSE4_1__
  return xsimd::floor(a);
#else
  // Adding 2^(digits - 1) to the size leaves no place for a fraction. Larger numbers are whole.
  const Batch<T> large(T(1) / std::numeric_limits<T>::epsilon());
  const Batch<T> size = abs(a);
  const Batch<T> nearest = with_sign<T>((size + large) - large, a);
  const Batch<T> whole = select<T>(nearest > a, nearest - Batch<T>(T(1)), nearest);
  return select<T>(size < large, whole, a);
#endif
}

#else
/// The lanes are an array.
inline constexpr bool has_machine_vectors = false;

/// 16 bytes of numbers, or of truths about them, in an array.
template <class T, class Lane = T>
struct alignas(16 / sizeof(T) * sizeof(Lane)) Lanes {
  static constexpr std::size_t size = 16 / sizeof(T);

  std::array<Lane, size> lanes;

  Lanes() = default;
  explicit(false) Lanes(Lane value) { lanes.fill(value); }

  [[nodiscard]] Lane get(std::size_t i) const { return lanes[i]; }
  void store_unaligned(Lane* to) const {
    for (std::size_t i = 0; i < size; ++i) to[i] = lanes[i];
  }
  [[nodiscard]] static Lanes load_aligned(const Lane* from) {
    return each([from](std::size_t i) { return from[i]; });
  }
  /// value(i) in lane `i`.
  template <class Value>
  [[nodiscard]] static Lanes each(const Value& value) {
    Lanes result;
    for (std::size_t i = 0; i < size; ++i) result.lanes[i] = value(i);
    return result;
  }

// An operator is that of each pair of lanes.
#define TEXMAP_OF_LANES(Result, op)                                                         \
  friend auto operator op(const Lanes& a, const Lanes& b) {                                 \
    return Lanes<T, Result>::each([&](std::size_t i) { return a.lanes[i] op b.lanes[i]; }); \
  }
  TEXMAP_OF_LANES(Lane, +)
  TEXMAP_OF_LANES(Lane, -)
  TEXMAP_OF_LANES(Lane, *)
  TEXMAP_OF_LANES(Lane, /)
  TEXMAP_OF_LANES(bool, <)
  TEXMAP_OF_LANES(bool, <=)
  TEXMAP_OF_LANES(bool, >)
  TEXMAP_OF_LANES(bool, >=)
  TEXMAP_OF_LANES(bool, ==)
  TEXMAP_OF_LANES(bool, &&)
  TEXMAP_OF_LANES(bool, ||)
#undef TEXMAP_OF_LANES
  friend auto operator-(const Lanes& a) {
    return each([&](std::size_t i) { return -a.lanes[i]; });
  }
  friend auto operator!(const Lanes& a) {
    return each([&](std::size_t i) { return !a.lanes[i]; });
  }
};
template <class T>
using Batch = Lanes<T>;
template <class T>
using BatchBool = Lanes<T, bool>;

template <class T>
[[nodiscard]] bool any(const BatchBool<T>& mask) {
  bool found = false;
  for (const bool lane : mask.lanes) found = found || lane;
  return found;
}
template <class T>
[[nodiscard]] Batch<T> select(const BatchBool<T>& mask, const Batch<T>& yes, const Batch<T>& no) {
  return Batch<T>::each([&](std::size_t i) { return mask.lanes[i] ? yes.lanes[i] : no.lanes[i]; });
}
template <class T>
[[nodiscard]] Batch<T> with_sign(const Batch<T>& size, const Batch<T>& sign) {
  return Batch<T>::each([&](std::size_t i) { return std::copysign(size.lanes[i], sign.lanes[i]); });
}
template <class T>
[[nodiscard]] Batch<T> negate(const Batch<T>& a) {
  return -a;
}
template <class T>
[[nodiscard]] Batch<T> divide(const Batch<T>& a, const Batch<T>& b) {
  return a / b;
}
// A function of a batch is that of each lane.
#define TEXMAP_OF_EACH_LANE(function)                                                \
  template <class T>                                                                 \
  [[nodiscard]] Batch<T> function(const Batch<T>& a) {                               \
    return Batch<T>::each([&](std::size_t i) { return std::function(a.lanes[i]); }); \
  }
TEXMAP_OF_EACH_LANE(abs)
TEXMAP_OF_EACH_LANE(sqrt)
TEXMAP_OF_EACH_LANE(floor)
#undef TEXMAP_OF_EACH_LANE
#endif

/// The widest instructions that this file is compiled for.
using default_arch = Registers<sizeof(Batch<float>)>;

}  // namespace texmap::simd
