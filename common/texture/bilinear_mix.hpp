// Bilinear interpolation.
#pragma once
#include "math/color.hpp"

namespace texmap {

/// Bilinear interpolation: the four texels around a place, mixed; a texel itself at its center.
///
/// @param texel_at  called with a column and a row, perhaps one beyond an edge; a color or a number
/// @param x, y      the place in texels, counted from the center of texel (0, 0)
template <class Real, class TexelAt>
[[nodiscard]] auto bilinear_mix(const TexelAt& texel_at, const Real& x, const Real& y) {
  const Real column = floor(x), row = floor(y);
  const auto row_of = [&](const Real& one) {
    return mix(texel_at(column, one), texel_at(column + Real(1), one), x - column);
  };
  const auto first = row_of(row);
  return mix(first, row_of(row + Real(1)), y - row);
}

}  // namespace texmap
