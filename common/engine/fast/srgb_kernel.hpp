// From light to bytes by the sRGB curve, without calling pow.
#pragma once
#include "engine/fast/polynomial.hpp"
#include "math/srgb.hpp"
#include "number/compiler.hpp"

namespace texmap {

/// The curve at `linear`, times 255 and not yet rounded.
///
/// @tparam Terms  of the polynomial: 3 or 4
/// @param linear  light; limited to [0, 1], NaN to 0
/// @return        -1.5 to 256.5
/// Bound: 1.5 and 0.49 levels; from one float to the next it falls by at most 0.00004.
template <int Terms, class Real>
[[nodiscard]] Real srgb_level(const Real& linear) {
  const Real light = clamp(linear, Real(0), Real(1));
  return select(light <= Real(0.0031308), light * Real(255 * 12.92),
                polynomial<fits::SrgbCurve<Terms>>(sqrt(light)));
}

/// The byte of `linear`, as a whole number from 0 to 255.
/// Bound: one from that of the exact curve with 4 terms, two with 3; where bytes meet, one
/// float's byte can be one more than the next one's.
template <int Terms, class Real>
[[nodiscard]] Real srgb_byte(const Real& linear) {
  return clamp(floor(srgb_level<Terms>(linear) + Real(0.5)), Real(0), Real(255));
}

/// Where the bytes of type `T` begin, and which one to try first: one comparison then decides.
template <class T>
struct SrgbBytes {
  static constexpr std::size_t pieces = 4096;  ///< of light: one holds at most one begin of a byte

  std::array<T, 257> least{};  ///< entry b: the least light with a byte of b or more; 256: infinity
  std::array<std::uint8_t, pieces + 1> first{};  ///< the byte of a piece's least light

  TEXMAP_NOINLINE SrgbBytes() {
    least[0] = -std::numeric_limits<T>::infinity();
    least[256] = std::numeric_limits<T>::infinity();
    for (std::size_t byte = 1; byte < 256; ++byte) {
      const long double light = srgb_decode((static_cast<long double>(byte) - 0.5L) / 255);
      least[byte] = static_cast<T>(light);
      if (static_cast<long double>(least[byte]) < light)
        least[byte] = std::nextafter(least[byte], T(1));
    }
    std::uint8_t byte = 0;
    for (std::size_t piece = 0; piece <= pieces; ++piece) {
      while (least[byte + std::size_t{1}] * pieces <= static_cast<T>(piece)) ++byte;
      first[piece] = byte;
    }
  }
};

/// The byte of `linear` by the exact curve: srgb_encode times 255, rounded to nearest.
///
/// @param linear  below 0 and NaN give 0, above 1 gives 255
/// Bound: exact; in a number as wide as long double, within 8 epsilons of a threshold, either byte.
template <class Real>
[[nodiscard]] Real srgb_byte_exact(const Real& linear) {
  using T = Scalar<Real>;
  static const SrgbBytes<T> bytes;
  const Real light = clamp(linear, Real(0), Real(1));
  return from_lanes<Real>([&](std::size_t i) {
    const T x = lane(light, i);
    const std::size_t byte = bytes.first[static_cast<std::size_t>(x * bytes.pieces)];
    return static_cast<T>(byte + std::size_t{x >= bytes.least[byte + 1]});  // without a branch
  });
}

}  // namespace texmap
