// Texels of a pyramid for packs with gather instructions.
#pragma once
#include "number/kinds/fetch.hpp"
#include "texture/pyramid.hpp"

namespace texmap {

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

/// The three channels of a texel in a row among those of all levels.
template <class Real>
requires can_fetch<Real>
[[nodiscard]] auto channels_in_row(const Pyramid& pyramid, std::uint32_t row,
                                   std::uint32_t column) {
  const std::size_t texel = pyramid.row_starts[row] + column;
  if (row >= static_cast<std::uint32_t>(pyramid.original.height))
    return channels_at<Real>(&pyramid.smaller.pixels[texel].r);
  const Color<float> light = pyramid.original[texel];
  return channels_of<Real>(light.r, light.g, light.b);
}

/// texel_light for all lanes at once.
template <class Real>
requires can_fetch<Real>
[[nodiscard]] Color<Real> texel_light(const Pyramid& pyramid, const PyramidLevel<Real>& level,
                                      const Real& column, const Real& row) {
  const auto columns = lane_integers(column);
  const auto rows = lane_integers(level.first_row + row);
  const auto channels = from_channels<Real>(
      [&](std::size_t i) { return channels_in_row<Real>(pyramid, rows[i], columns[i]); });
  return {channels[0], channels[1], channels[2]};
}

/// mixed_light: each lane mixes its four texels with their three channels at once.
/// Textbook: mixes of packs, for which 12 packs would have to be collected first.
template <class Real>
requires can_fetch<Real>
[[nodiscard]] Color<Real> mixed_light(const Pyramid& pyramid, const PyramidLevel<Real>& level,
                                      const Neighbors<Real>& columns, const Neighbors<Real>& rows,
                                      const Real& across, const Real& down) {
  // As `mix` does, start from the nearer texel.
  const Mask<Real> from_left = across < Real(0.5), from_top = down < Real(0.5);
  const auto near_columns = lane_integers(select(from_left, columns.first, columns.second));
  const auto far_columns = lane_integers(select(from_left, columns.second, columns.first));
  const auto near_rows = lane_integers(level.first_row + select(from_top, rows.first, rows.second));
  const auto far_rows = lane_integers(level.first_row + select(from_top, rows.second, rows.first));
  const auto to_far_column = all_lanes(select(from_left, across, Real(1) - across));
  const auto to_far_row = all_lanes(select(from_top, down, Real(1) - down));

  const auto channels = from_channels<Real>([&](std::size_t i) {
    const auto mixed = [](const auto& a, const auto& b, const auto& t) { return a + t * (b - a); };
    const auto across_row = [&](std::uint32_t row) {
      return mixed(channels_in_row<Real>(pyramid, row, near_columns[i]),
                   channels_in_row<Real>(pyramid, row, far_columns[i]),
                   four_times<Real>(to_far_column[i]));
    };
    return mixed(across_row(near_rows[i]), across_row(far_rows[i]),
                 four_times<Real>(to_far_row[i]));
  });
  return {channels[0], channels[1], channels[2]};
}

}  // namespace texmap
