// From a texture coordinate to the row or column of a texel.
#pragma once
#include <type_traits>

#include "number.hpp"

namespace texmap {

/// How a coordinate becomes a texel.
enum class TexelRounding {
  floor,    ///< floor(u n): every texel has the same share of the surface
  lecture,  ///< (int)((n - 1) u), seed 4: half a texel off on average, and the last row and column have no share at all
};

/// A whole number that says which texel: an integer for one number at a time, which reads memory by it; a number itself in
/// packs and intervals.
template <class Real>
using TexelNumber = std::conditional_t<std::is_floating_point_v<Real>, int, Real>;

/// `x` brought to a whole number from 0 to n - 1 that is safe to index with: below 0 and NaN give 0, n and above give n - 1.
///
/// @param x  anything the type can hold, infinities too
/// @param n  number of texels, 1 to 2^24: beyond, float does not hold every index
/// @return   floor(x) for x in [0, n), without an error
/// Errors: none.
template <class Real>
[[nodiscard]] TexelNumber<Real> clamp_number(const Real& x, int n) {
  const Real inside = clamp(x, Real(0), Real(n - 1));
  if constexpr (std::is_floating_point_v<Real>) {
    return static_cast<int>(inside);  // the floor, for 0 and above
  } else {
    return floor(inside);
  }
}
/// The same as a number of that type.
template <class Real>
[[nodiscard]] Real clamp_index(const Real& x, int n) {
  return static_cast<Real>(clamp_number(x, n));
}

/// The texel that holds coordinate `u`, from 0 to n - 1.
///
/// @param u  texture coordinate, 0 to 1; anything else is clamped to the nearest texel, and NaN gives 0
/// @param n  number of texels along the coordinate, 1 to 2^24
/// Bound: for u in [0, 1) the texel holds u but for 1 unit roundoff of 1; docs/numbers.md.
/// Errors: none. The clamp comes before any conversion to an integer, so that no NaN and no infinity reaches one.
/// Source: seeds 2 (floor) and 4 (lecture).
template <class Real>
[[nodiscard]] TexelNumber<Real> texel_number(const Real& u, int n, TexelRounding rounding) {
  return clamp_number(u * Real(rounding == TexelRounding::floor ? n : n - 1), n);
}
/// The same as a number of that type.
template <class Real>
[[nodiscard]] Real texel_index(const Real& u, int n, TexelRounding rounding = TexelRounding::floor) {
  return static_cast<Real>(texel_number(u, n, rounding));
}

/// The texel of a coordinate on an image that repeats: u and u + 1 are one place, negative ones included.
///
/// @param u  any finite coordinate; NaN and infinities give a texel too
/// @param n  number of texels, 1 to 2^24
/// Bound: the texel holds u but for 1.5 unit roundoffs of 1, for u to 1e12 and beyond; docs/numbers.md.
template <class Real>
[[nodiscard]] Real wrapped_index(const Real& u, int n) {
  return clamp_index((u - floor(u)) * Real(n), n);
}

}  // namespace texmap
