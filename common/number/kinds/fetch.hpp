// Reads many places of memory at once, one for each lane of a pack (gather instructions).
#pragma once
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
#endif

}  // namespace texmap
