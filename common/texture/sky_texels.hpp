// The texels of a sky as parts of the sphere: how large each is, and how much light it holds.
#pragma once
#include <bit>
#include <cstdint>
#include <numbers>
#include <vector>

#include "math/color.hpp"

namespace texmap {

/// One row of an equirectangular map as a band of the unit sphere.
struct SkyBand {
  double from = 0, to = 0;  ///< 1 - y_sign y of its edges, from the map's upper edge down
  double y_sign = 1;        ///< +1 for bands measured from +y, -1 for those from -y
  double solid_angle = 0;   ///< of each texel in it, in steradians

  /// @param row, width, height  of the map, the row from the top
  /// Textbook: cos a - cos b for polar angles a and b. Here products of sines: no digits cancel.
  SkyBand(int row, int width, int height) {
    const auto polar_angle = [height](int edge) { return std::numbers::pi * edge / height; };
    const bool upper = 2 * row + 1 <= height;
    const auto below_pole = [&](int edge) {
      return 2 * square(sin(polar_angle(upper ? edge : height - edge) / 2));
    };
    from = below_pole(row);
    to = below_pole(row + 1);
    y_sign = upper ? 1 : -1;
    const int edges = upper ? 2 * row + 1 : 2 * (height - row) - 1;  // to the middle, in half rows
    solid_angle =
        2 * std::numbers::pi / width * 2 * sin(polar_angle(1) / 2) * sin(polar_angle(edges) / 2);
  }
};

/// The numbers of a map's texels, row by row from the top, in an order that keeps neighbors near
/// each other: the four quarters of a square one after another, each in the same order.
/// Source: Morton (1966), the Z-order.
[[nodiscard]] inline std::vector<std::uint32_t> z_order(int width, int height) {
  std::vector<std::uint32_t> order;
  const auto add_square = [&](const auto& self, int column, int row, int side) -> void {
    if (column >= width || row >= height) return;
    if (side == 1) {
      order.push_back(static_cast<std::uint32_t>(row * width + column));
      return;
    }
    const int half = side / 2;
    for (int quarter = 0; quarter < 4; ++quarter)
      self(self, column + half * (quarter % 2), row + half * (quarter / 2), half);
  };
  add_square(add_square, 0, 0,
             static_cast<int>(std::bit_ceil(static_cast<unsigned>(max(width, height)))));
  return order;
}

/// The brightness of light to the sampler: the mean of its channels.
[[nodiscard]] inline double brightness_of(const Color<float>& light) {
  const auto wide = number_cast<double>(light);
  return (wide.r + wide.g + wide.b) / 3;
}

}  // namespace texmap
