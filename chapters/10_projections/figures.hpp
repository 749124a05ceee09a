// What a layout costs: the largest texel, the worst stretch, the length of its seams, time.
#pragma once
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

/// The table that the chapter prints.
[[nodiscard]] std::string table_of_figures();

}  // namespace texmap::chapter_10
