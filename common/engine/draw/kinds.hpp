// The kinds of lessons that are drawn in another way than a color for each ray. A lesson is derived
// from one: PathLesson, FilteredLesson, MeshLesson.
#pragma once

namespace texmap {

/// It follows one path a call, many for each pixel (gather.hpp).
struct GathersLight {};

/// Its colors are light: a pixel shows the sRGB color of their mean.
struct ShowsMeanLight {
  virtual ~ShowsMeanLight() = default;
  /// True if rays bring their derivatives by the pixel's column and row.
  [[nodiscard]] virtual bool needs_footprints() const = 0;
};

/// Its rays meet a mesh: packs of them meet fewer triangles as blocks of pixels than as rows.
struct HasMesh {};

}  // namespace texmap
