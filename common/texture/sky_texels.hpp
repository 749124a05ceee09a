// The texels of a sky as parts of the sphere: how large each is, and how much light it holds.
#pragma once
#include <cmath>
#include <numbers>
#include <vector>

#include "texture/environment.hpp"

namespace texmap {

/// One row of an equirectangular map as a band of the unit sphere.
struct SkyBand {
  double from = 0, to = 0;  ///< 1 - |y| of its edges, from the map's upper edge to its lower one
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
    solid_angle = 2 * std::numbers::pi / width * 2 * std::sin(polar_angle(1) / 2) *
                  std::sin((polar_angle(row) + polar_angle(row + 1)) / 2);
  }
};

/// The brightness of light to the sampler: the mean of its channels.
[[nodiscard]] inline double brightness_of(const Color<float>& light) {
  return (static_cast<double>(light.r) + static_cast<double>(light.g) +
          static_cast<double>(light.b)) /
         3;
}

/// The mean brightness of a sky over each of its texels, row by row from the top; the bilinear
/// filter brings 1/8 from the neighbor on each side, over the poles too.
[[nodiscard]] inline std::vector<double> brightness_of_texels(const Environment& sky) {
  const LightImage& map = sky.map();
  std::vector<double> brightness;
  brightness.reserve(map.texels.size());
  const auto at = [&](int column, int row) {
    const auto inside =
        wrapped_texel<double>(Wrap::spherical, column, row, map.width, map.height);
    return brightness_of(map.at(static_cast<int>(inside.column), static_cast<int>(inside.row)));
  };
  const auto across = [&](int column, int row) {
    return 0.75 * at(column, row) + 0.125 * (at(column - 1, row) + at(column + 1, row));
  };
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      brightness.push_back(sky.filter() == TexelFilter::nearest
                               ? at(column, row)
                               : 0.75 * across(column, row) +
                                     0.125 * (across(column, row - 1) + across(column, row + 1)));
    }
  }
  return brightness;
}

}  // namespace texmap
