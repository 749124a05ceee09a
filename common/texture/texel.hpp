// From a texture coordinate to the column or row of a texel.
#pragma once
#include <type_traits>

#include "number/number.hpp"

namespace texmap {

/// How a coordinate becomes a texel.
enum class TexelRounding {
  floor,    ///< floor(u n): every texel covers the same share of the surface
  lecture,  ///< (int)((n - 1) u), the lecture: half a texel off; the last texel only at u = 1
};

/// The number of a texel: an integer for plain numbers, a whole number for packs and intervals.
template <class Real>
using TexelNumber = std::conditional_t<std::is_floating_point_v<Real>, int, Real>;

/// floor(x) limited to [0, n - 1], a safe index; NaN gives 0.
///
/// @param x  any number
/// @param n  number of texels, 1 to 2^24, which float holds
template <class Real>
[[nodiscard]] TexelNumber<Real> clamp_number(const Real& x, int n) {
  const Real inside = clamp(x, Real(0), Real(n - 1));
  if constexpr (std::is_floating_point_v<Real>) {
    return static_cast<int>(inside);  // the floor, for 0 and above
  } else {
    return floor(inside);
  }
}

/// The texel that holds coordinate `u`, from 0 to n - 1.
///
/// @param u  0 to 1; outside, the nearest texel; NaN gives 0
/// @param n  number of texels, 1 to 2^24
/// Source: Next Week (floor), the lecture (lecture).
template <class Real>
[[nodiscard]] TexelNumber<Real> texel_number(const Real& u, int n, TexelRounding rounding) {
  return clamp_number(u * Real(rounding == TexelRounding::floor ? n : n - 1), n);
}

}  // namespace texmap
