// A renderer's look-up in a pyramid of a texture, to compare with `Filter::trilinear`.
#pragma once
#include <algorithm>

#include "texture/filters.hpp"

namespace texmap::published {

/// The light of a pixel's footprint: two levels of the pyramid, mixed.
///
/// @param texture  wraps in any way but `border`; its rows count down, as v does
/// @param uv       of single numbers
/// Fails for long textures: one width in (u, v) stands for both sides. A NaN becomes the color.
/// Source: MIPMap::Lookup of pbrt-v3.
template <class Texels, class Real>
[[nodiscard]] Color<Real> trilinear(const Filtered<Texels>& texture, const Uv<Dual<Real>>& uv) {
  const Real width = Real(2) * std::max(std::max(abs(uv.u.dx), abs(uv.v.dx)),
                                        std::max(abs(uv.u.dy), abs(uv.v.dy)));
  const Real last = Real(texture.pyramid.last_level());
  // The binary logarithm, of numbers that lack it.
  const Real level = last + log1p(std::max(width, Real(1e-8)) - Real(1)) / log1p(Real(1));

  // Of a place or a level that is no number, the weights of the texels are none either.
  const Uv<Real> at{uv.u.value, uv.v.value};
  const Real weight = at.u - floor(at.u) + at.v - floor(at.v) + level;
  const bool is_number = weight <= weight;  // NaN is not; NOLINT(misc-redundant-expression)
  if (!is_number) return gray(weight);
  const auto read = [&](const Real& number) {
    return texture.bilinear(at, level_of(texture.pyramid, number));
  };
  if (level < Real(0)) return read(Real(0));
  if (level >= last) return read(last);
  const Real fine = floor(level);
  return mix(read(fine), read(fine + Real(1)), level - fine);
}

}  // namespace texmap::published
