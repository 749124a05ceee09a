// Texels of a pyramid for packs with gather instructions.
#pragma once
#include "number/kinds/fetch.hpp"
#include "texture/pyramid.hpp"

namespace texmap {

/// True for packs of float. In packs of double the general version is as fast: it reads as many
/// places, and converts them in the registers.
template <class Real>
inline constexpr bool can_fetch_light = can_fetch<Real>&& std::is_same_v<Scalar<Real>, float>;

/// level_of for all lanes at once. Neighboring pixels mostly read one level.
template <class Real>
requires can_fetch<Real>
[[nodiscard]] PyramidLevel<Real> level_of(const Pyramid& pyramid, const Real& number) {
  const Scalar<Real> first = lane(number, 0);
  if (!any(number < Real(first)) && !any(Real(first) < number)) {
    const PyramidLevel<int>& one = pyramid.levels[static_cast<std::size_t>(first)];
    return {Real(one.width), Real(one.height), Real(one.first_row)};
  }
  using Integers = UInt<Real>;
  const Integers level = uint_from_real(number) * 3U;
  const auto part = [&](std::uint32_t which) {
    return real_from_uint<Real>(fetch_four_bytes<Real, 4>(pyramid.levels.data(), level + which));
  };
  return {part(0), part(1), part(2)};
}

/// texel_light for all lanes at once. Domain: pyramids of at most 2^29 texels.
template <class Real>
requires can_fetch_light<Real>
[[nodiscard]] Color<Real> texel_light(const Pyramid& pyramid, const PyramidLevel<Real>& level,
                                      const Real& column, const Real& row) {
  using Integers = UInt<Real>;
  // Of the 64 bits of a row's start the lower 32 are enough.
  const Integers start =
      fetch_four_bytes<Real, 4>(pyramid.row_starts.data(), uint_from_real(level.first_row) * 2U);
  const Integers texel =
      (start + uint_from_real(row) * uint_from_real(level.width) + uint_from_real(column)) * 3U;
  const auto channels = fetch_three_floats<Real>(&pyramid.texels.data()->r, texel);
  return {channels[0], channels[1], channels[2]};
}

}  // namespace texmap
