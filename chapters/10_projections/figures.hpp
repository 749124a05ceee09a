// What a layout costs: the largest texel, the worst stretch, the length of its seams, time.
#pragma once
#include <array>
#include <string>

#include "texture/projection_facts.hpp"

namespace texmap::chapter_10 {

/// The closed forms of a projection. `infinity` where nothing bounds them.
struct ClosedForms {
  double largest_texel;      ///< its solid angle / that of the mean texel
  double worst_stretch;      ///< see Distortion
  Vec3<double> worst_place;  ///< where the stretch tends to that
};
[[nodiscard]] ClosedForms closed_forms(Projection projection);

/// The length of all seams on the sphere in degrees: where neighbors are no neighbors in the
/// picture. Measured: the edges of the picture, followed on the sphere, meet each seam twice.
[[nodiscard]] double seam_degrees(Projection projection);

/// The mean over the sphere of what `value` gives for a direction, by the picture's texels: each
/// counts as much as the sphere that it covers, by the duals.
///
/// @param rows  of texels, 2 or more
template <class Value>
[[nodiscard]] double mean_by_texels(Projection projection, int rows, const Value& value) {
  const int columns = rows * 3 / 2;
  double sum = 0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Vec3<double> n =
          unproject(projection, Uv<double>{(column + 0.5) / columns, (row + 0.5) / rows});
      sum += value(n) * distortion(projection, n).area;
    }
  }
  return sum / (static_cast<double>(rows) * columns);
}

/// Times of a projection / those of the equirectangular one.
struct RelativeTimes {
  double forward, inverse;
};
[[nodiscard]] std::array<RelativeTimes, projections.size()> measure_times();

/// The table that the chapter prints.
[[nodiscard]] std::string table_of_figures();

}  // namespace texmap::chapter_10
