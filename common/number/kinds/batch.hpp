// What packs are built on: xsimd's batches if CMake found xsimd, else arrays with the same names.
#pragma once
#ifdef TEXMAP_HAVE_XSIMD
#include <type_traits>
#include <xsimd/xsimd.hpp>

namespace texmap::simd {

/// True where a batch is a vector of the machine's.
inline constexpr bool has_machine_vectors = true;

using xsimd::abs;
using xsimd::any;
using xsimd::batch;
using xsimd::batch_bool;
using xsimd::bitofsign;
using xsimd::exp;
using xsimd::floor;
using xsimd::log1p;
using xsimd::max;
using xsimd::min;
using xsimd::select;

#if XSIMD_WITH_FMA3_AVX2
/// The widest instructions that code is compiled for, without those that multiply and add at once:
/// they round once, and the pictures would differ.
using default_arch =
    std::conditional_t<std::is_same_v<xsimd::default_arch, xsimd::fma3<xsimd::avx2>>, xsimd::avx2,
                       xsimd::default_arch>;
#else
using xsimd::default_arch;
#endif

/// a / b, rounded in each lane like a single number.
template <class T, class Arch>
[[nodiscard]] batch<T, Arch> divide(const batch<T, Arch>& a, const batch<T, Arch>& b) {
#ifdef __aarch64__  // xsimd 8 divides floats by Newton's method there
  if constexpr (std::is_same_v<T, float>) return batch<T, Arch>(vdivq_f32(a, b));
#endif
  return a / b;
}

/// The square root, rounded in each lane like a single number's.
template <class T, class Arch>
[[nodiscard]] batch<T, Arch> sqrt(const batch<T, Arch>& a) {
#ifdef __aarch64__
  if constexpr (std::is_same_v<T, float>) return batch<T, Arch>(vsqrtq_f32(a));
#endif
  return xsimd::sqrt(a);
}

}  // namespace texmap::simd

#else
#include <array>
#include <cmath>
#include <cstddef>

namespace texmap::simd {

/// The lanes are an array.
inline constexpr bool has_machine_vectors = false;

/// No particular machine instructions.
struct default_arch {};

/// 16 bytes of numbers in an array.
template <class T>
inline constexpr std::size_t batch_size = 16 / sizeof(T);

// An operator of two batches, or of their masks, is that of each pair of lanes.
#define TEXMAP_OF_LANES(Result, Operand, op)                                      \
  friend auto operator op(const Operand& a, const Operand& b) {                   \
    return Result::each([&](std::size_t i) { return a.lanes[i] op b.lanes[i]; }); \
  }

template <class T, class Arch>
struct batch_bool {
  std::array<bool, batch_size<T>> lanes{};

  TEXMAP_OF_LANES(batch_bool, batch_bool, &&)
  TEXMAP_OF_LANES(batch_bool, batch_bool, ||)
  friend batch_bool operator!(const batch_bool& a) {
    return each([&](std::size_t i) { return !a.lanes[i]; });
  }
  template <class Value>
  [[nodiscard]] static batch_bool each(const Value& value) {
    batch_bool result;
    for (std::size_t i = 0; i < result.lanes.size(); ++i) result.lanes[i] = value(i);
    return result;
  }
};

template <class T, class Arch>
struct alignas(16) batch {
  static constexpr std::size_t size = batch_size<T>;
  using Mask = batch_bool<T, Arch>;

  std::array<T, size> lanes;

  batch() = default;
  explicit(false) batch(T value) { lanes.fill(value); }

  [[nodiscard]] T get(std::size_t i) const { return lanes[i]; }
  void store_unaligned(T* to) const {
    for (std::size_t i = 0; i < size; ++i) to[i] = lanes[i];
  }
  [[nodiscard]] static batch load_aligned(const T* from) {
    return each([from](std::size_t i) { return from[i]; });
  }

  TEXMAP_OF_LANES(batch, batch, +)
  TEXMAP_OF_LANES(batch, batch, -)
  TEXMAP_OF_LANES(batch, batch, *)
  TEXMAP_OF_LANES(batch, batch, /)
  TEXMAP_OF_LANES(Mask, batch, <)
  TEXMAP_OF_LANES(Mask, batch, <=)
  TEXMAP_OF_LANES(Mask, batch, >)
  TEXMAP_OF_LANES(Mask, batch, >=)
  TEXMAP_OF_LANES(Mask, batch, ==)
  friend batch operator-(const batch& a) {
    return each([&](std::size_t i) { return -a.lanes[i]; });
  }
  /// `a`, 0 or more, with the sign that `bitofsign` returned.
  friend batch operator|(const batch& a, const batch& sign) {
    return each([&](std::size_t i) {
      return std::signbit(sign.lanes[i]) ? -std::abs(a.lanes[i]) : a.lanes[i];
    });
  }

  template <class Value>
  [[nodiscard]] static batch each(const Value& value) {
    batch result;
    for (std::size_t i = 0; i < size; ++i) result.lanes[i] = value(i);
    return result;
  }
};

template <class T, class Arch>
[[nodiscard]] batch<T, Arch> divide(const batch<T, Arch>& a, const batch<T, Arch>& b) {
  return a / b;
}
template <class T, class Arch>
[[nodiscard]] bool any(const batch_bool<T, Arch>& a) {
  bool found = false;
  for (const bool lane : a.lanes) found = found || lane;
  return found;
}
template <class T, class Arch>
[[nodiscard]] batch<T, Arch> select(const batch_bool<T, Arch>& mask, const batch<T, Arch>& yes,
                                    const batch<T, Arch>& no) {
  return batch<T, Arch>::each(
      [&](std::size_t i) { return mask.lanes[i] ? yes.lanes[i] : no.lanes[i]; });
}
template <class T, class Arch>
[[nodiscard]] batch<T, Arch> max(const batch<T, Arch>& a, const batch<T, Arch>& b) {
  return select(a > b, a, b);
}
template <class T, class Arch>
[[nodiscard]] batch<T, Arch> min(const batch<T, Arch>& a, const batch<T, Arch>& b) {
  return select(a < b, a, b);
}
// A function of a batch is that of each lane.
#define TEXMAP_OF_EACH_LANE(function)                                                      \
  template <class T, class Arch>                                                           \
  [[nodiscard]] batch<T, Arch> function(const batch<T, Arch>& a) {                         \
    return batch<T, Arch>::each([&](std::size_t i) { return std::function(a.lanes[i]); }); \
  }
TEXMAP_OF_EACH_LANE(abs)
TEXMAP_OF_EACH_LANE(sqrt)
TEXMAP_OF_EACH_LANE(floor)
TEXMAP_OF_EACH_LANE(exp)
TEXMAP_OF_EACH_LANE(log1p)
#undef TEXMAP_OF_EACH_LANE
#undef TEXMAP_OF_LANES

/// Zeros with the signs of `a`.
template <class T, class Arch>
[[nodiscard]] batch<T, Arch> bitofsign(const batch<T, Arch>& a) {
  return batch<T, Arch>::each([&](std::size_t i) { return std::copysign(T(0), a.lanes[i]); });
}

}  // namespace texmap::simd
#endif
