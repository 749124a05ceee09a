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

/// The entries of a table of 256 at the lowest 8 bits of each place. Where two registers hold 32
/// floats, eight permutations of them and a choice by each higher bit are faster than a gather.
template <class Real>
[[nodiscard]] inline Real fetch_of_256(const Scalar<Real>* table, const UInt<Real>& places) {
  if constexpr (requires(Real x) { x.first; }) {
    using Half = decltype(Real::first);
    return {fetch_of_256<Half>(table, places.first), fetch_of_256<Half>(table, places.second)};
  } else if constexpr (std::is_same_v<Scalar<Real>, float> && lanes<Real> == 16) {
#if defined(__AVX512F__)
    const auto index = std::bit_cast<__m512i>(places);
    __m512 entries[8];
    for (int i = 0; i < 8; ++i)
      entries[i] = _mm512_permutex2var_ps(_mm512_loadu_ps(table + 32 * i), index,
                                          _mm512_loadu_ps(table + 32 * i + 16));
    for (int bit = 32, left = 4; left > 0; bit *= 2, left /= 2) {
      const __mmask16 upper = _mm512_test_epi32_mask(index, _mm512_set1_epi32(bit));
      for (int i = 0; i < left; ++i)
        entries[i] = _mm512_mask_blend_ps(upper, entries[2 * i], entries[2 * i + 1]);
    }
    return typename Real::Batch(entries[0]);
#endif
  } else {
    const UInt<Real> entry = places & 255U;
    if constexpr (std::is_same_v<Scalar<Real>, float>) {
      return typename Real::Batch(_mm256_i32gather_ps(table, std::bit_cast<__m256i>(entry), 4));
    } else if constexpr (lanes<Real> == 4) {
      return typename Real::Batch(_mm256_i32gather_pd(table, std::bit_cast<__m128i>(entry), 8));
    } else {
#if defined(__AVX512F__)
      return typename Real::Batch(_mm512_i32gather_pd(std::bit_cast<__m256i>(entry), table, 8));
#endif
    }
  }
}

/// A pack's numbers as integers, lane by lane. Domain: 0 to 2^31 - 1.
template <class Real>
[[nodiscard]] inline std::array<std::uint32_t, lanes<Real>> lane_integers(const Real& x) {
  return std::bit_cast<std::array<std::uint32_t, lanes<Real>>>(uint_from_real(x));
}

/// Four numbers of one lane that are computed at once: three channels, and one that is not used.
template <class Number>
struct FourOf;
template <>
struct FourOf<float> {
  // NOLINTNEXTLINE(modernize-use-using): GCC 12 ignores the attributes of an alias
  typedef __m128 Type;
};
template <>
struct FourOf<double> {
  typedef __m256d Type;  // NOLINT(modernize-use-using): as above
};
/// The four numbers of a lane of Real. Functions of them have Real in their names, see wide_packs.
template <class Real>
using LaneFour = typename FourOf<Scalar<Real>>::Type;

/// Three floats in one register, which may have a fourth.
template <class Real>
[[nodiscard]] inline LaneFour<Real> channels_of(__m128 channels) {
  if constexpr (std::is_same_v<Scalar<Real>, float>) return channels;
  if constexpr (std::is_same_v<Scalar<Real>, double>) return _mm256_cvtps_pd(channels);
}
/// Three floats that follow each other; it reads no fourth.
template <class Real>
[[nodiscard]] inline LaneFour<Real> channels_at(const float* first) {
  return channels_of<Real>(_mm_maskload_ps(first, _mm_setr_epi32(-1, -1, -1, 0)));
}
/// Three floats.
template <class Real>
[[nodiscard]] inline LaneFour<Real> channels_of(float r, float g, float b) {
  return channels_of<Real>(_mm_setr_ps(r, g, b, 0));
}
/// The same number four times.
template <class Real>
[[nodiscard]] inline LaneFour<Real> four_times(Scalar<Real> x) {
  if constexpr (std::is_same_v<Scalar<Real>, float>) return _mm_set1_ps(x);
  if constexpr (std::is_same_v<Scalar<Real>, double>) return _mm256_set1_pd(x);
}

/// Packs of the first, the second and the third channel, from channels(i) of lane `i`.
/// One load a lane and a transposition are faster than three gather instructions.
template <class Real, class Channels>
[[nodiscard]] inline std::array<Real, 3> from_channels(const Channels& channels) {
  if constexpr (requires(Real x) { x.first; }) {
    using Half = decltype(Real::first);
    const auto a = from_channels<Half>(channels);
    const auto b =
        from_channels<Half>([&channels](std::size_t i) { return channels(i + lanes<Half>); });
    return {Real{a[0], b[0]}, Real{a[1], b[1]}, Real{a[2], b[2]}};
  } else {
    struct Fours {
      LaneFour<Real> at[lanes<Real> / 4];
    };
    Fours r, g, b;
    for (std::size_t i = 0; i < lanes<Real> / 4; ++i) {
      LaneFour<Real> first = channels(4 * i), second = channels(4 * i + 1);
      LaneFour<Real> third = channels(4 * i + 2), fourth = channels(4 * i + 3);
      if constexpr (std::is_same_v<Scalar<Real>, float>) {
        _MM_TRANSPOSE4_PS(first, second, third, fourth);
        r.at[i] = first;
        g.at[i] = second;
        b.at[i] = third;
      } else {
        const __m256d reds = _mm256_unpacklo_pd(first, second);       // r0 r1 b0 b1
        const __m256d more_reds = _mm256_unpacklo_pd(third, fourth);  // r2 r3 b2 b3
        r.at[i] = _mm256_permute2f128_pd(reds, more_reds, 0x20);
        b.at[i] = _mm256_permute2f128_pd(reds, more_reds, 0x31);
        g.at[i] = _mm256_permute2f128_pd(_mm256_unpackhi_pd(first, second),
                                         _mm256_unpackhi_pd(third, fourth), 0x20);
      }
    }
    const auto pack = [](const Fours& fours) {
      return Real(std::bit_cast<typename Real::Batch>(fours));
    };
    return {pack(r), pack(g), pack(b)};
  }
}
#endif

}  // namespace texmap
