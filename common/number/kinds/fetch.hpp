// Reads many places of memory at once, one for each lane of a pack (gather instructions).
#pragma once
#include <array>
#include <bit>
#include <cstdint>

#include "number/kinds/pack2.hpp"

#ifdef __AVX2__
#include <immintrin.h>
#endif

namespace texmap {

/// True for packs of AVX2 and wider instructions. Other packs read lane by lane (look_up).
template <class Real>
inline constexpr bool can_fetch = false;

#ifdef __AVX2__
template <class T, class Arch>
inline constexpr bool can_fetch<Pack<T, Arch>> =
    simd::has_machine_vectors&& lanes<Pack<T, Arch>> >= 4;
template <class Half>
inline constexpr bool can_fetch<Pack2<Half>> = can_fetch<Half>;

/// Four bytes from each of many places, the first byte in the lowest 8 bits.
///
/// @tparam step   bytes from one place to the next, 1 or 4
/// @param from    place 0; need not be aligned
/// @param places  0 to 2^31 - 1, each with 4 bytes of the same array
template <class Real, int step>
[[nodiscard]] inline UInt<Real> fetch_four_bytes(const void* from, const UInt<Real>& places) {
  if constexpr (requires(Real x) { x.first; }) {
    using Half = decltype(Real::first);
    return {fetch_four_bytes<Half, step>(from, places.first),
            fetch_four_bytes<Half, step>(from, places.second)};
  } else if constexpr (lanes<Real> == 4) {
    return std::bit_cast<UInt<Real>>(
        _mm_i32gather_epi32(static_cast<const int*>(from), std::bit_cast<__m128i>(places), step));
  } else if constexpr (lanes<Real> == 8) {
    return std::bit_cast<UInt<Real>>(_mm256_i32gather_epi32(static_cast<const int*>(from),
                                                            std::bit_cast<__m256i>(places), step));
  } else {
#if defined(__AVX512F__)
    return std::bit_cast<UInt<Real>>(
        _mm512_i32gather_epi32(std::bit_cast<__m512i>(places), from, step));
#endif
  }
}

/// The entries of a table at many places, each below 2^31.
template <class Real>
[[nodiscard]] inline Real fetch(const Scalar<Real>* table, const UInt<Real>& places) {
  if constexpr (requires(Real x) { x.first; }) {
    using Half = decltype(Real::first);
    return {fetch<Half>(table, places.first), fetch<Half>(table, places.second)};
  } else if constexpr (std::is_same_v<Scalar<Real>, float>) {
    if constexpr (lanes<Real> == 4) {
      return typename Real::Batch(_mm_i32gather_ps(table, std::bit_cast<__m128i>(places), 4));
    } else if constexpr (lanes<Real> == 8) {
      return typename Real::Batch(_mm256_i32gather_ps(table, std::bit_cast<__m256i>(places), 4));
    } else {
#if defined(__AVX512F__)
      return typename Real::Batch(_mm512_i32gather_ps(std::bit_cast<__m512i>(places), table, 4));
#endif
    }
  } else {
    if constexpr (lanes<Real> == 4) {
      return typename Real::Batch(_mm256_i32gather_pd(table, std::bit_cast<__m128i>(places), 8));
    } else {
#if defined(__AVX512F__)
      return typename Real::Batch(_mm512_i32gather_pd(std::bit_cast<__m256i>(places), table, 8));
#endif
    }
  }
}

/// Three floats that follow each other, at each of many places. For packs of float.
///
/// @param places  of the first of the three, below 2^31
template <class Real>
[[nodiscard]] inline std::array<Real, 3> fetch_three_floats(const float* table,
                                                            const UInt<Real>& places) {
  if constexpr (requires(Real x) { x.first; }) {
    using Half = decltype(Real::first);
    const auto first = fetch_three_floats<Half>(table, places.first);
    const auto second = fetch_three_floats<Half>(table, places.second);
    return {Real{first[0], second[0]}, Real{first[1], second[1]}, Real{first[2], second[2]}};
  } else {
    // One load a lane and a transposition are faster than three gather instructions.
    constexpr std::size_t count = lanes<Real>;
    const auto offsets = std::bit_cast<std::array<std::uint32_t, count>>(places);
    struct Fours {
      __m128 at[count / 4];
    };
    Fours channels[3];
    const __m128i three = _mm_setr_epi32(-1, -1, -1, 0);
    for (std::size_t i = 0; i < count / 4; ++i) {
      __m128 a = _mm_maskload_ps(table + offsets[4 * i], three);
      __m128 b = _mm_maskload_ps(table + offsets[4 * i + 1], three);
      __m128 c = _mm_maskload_ps(table + offsets[4 * i + 2], three);
      __m128 d = _mm_maskload_ps(table + offsets[4 * i + 3], three);
      _MM_TRANSPOSE4_PS(a, b, c, d);
      channels[0].at[i] = a;
      channels[1].at[i] = b;
      channels[2].at[i] = c;
    }
    const auto numbers = [](const Fours& fours) {
      if constexpr (count == 4) {
        return Real(typename Real::Batch(fours.at[0]));
      } else if constexpr (count == 8) {
        return Real(typename Real::Batch(_mm256_set_m128(fours.at[1], fours.at[0])));
      } else {
#if defined(__AVX512F__)
        const __m512 low = _mm512_insertf32x4(_mm512_castps128_ps512(fours.at[0]), fours.at[1], 1);
        const __m512 half = _mm512_insertf32x4(low, fours.at[2], 2);
        return Real(typename Real::Batch(_mm512_insertf32x4(half, fours.at[3], 3)));
#endif
      }
    };
    return {numbers(channels[0]), numbers(channels[1]), numbers(channels[2])};
  }
}
#endif

}  // namespace texmap
