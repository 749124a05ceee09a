// The texels of a sky as parts of the sphere: how large each is, and how much light it holds.
#pragma once
#include <cmath>
#include <numbers>

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
      return 2 * square(std::sin(polar_angle(upper ? edge : height - edge) / 2));
    };
    from = below_pole(row);
    to = below_pole(row + 1);
    y_sign = upper ? 1 : -1;
    const int edges = upper ? 2 * row + 1 : 2 * (height - row) - 1;  // to the middle, in half rows
    solid_angle = 2 * std::numbers::pi / width * 2 * std::sin(polar_angle(1) / 2) *
                  std::sin(polar_angle(edges) / 2);
  }
};

/// The brightness of light to the sampler: the mean of its channels.
[[nodiscard]] inline double brightness_of(const Color<float>& light) {
  return (static_cast<double>(light.r) + static_cast<double>(light.g) +
          static_cast<double>(light.b)) /
         3;
}

}  // namespace texmap
