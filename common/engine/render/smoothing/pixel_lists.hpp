// The pixels of some rows, sorted by how their samples are drawn.
#pragma once
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "engine/render/smoothing/pixel_probe.hpp"
#include "math/color.hpp"

namespace texmap {

/// What is known of the picture of a lone sphere before a sample is drawn.
struct ViewBounds {
  std::optional<Rgb> light;  ///< of the sky, if it is uniform
  Smoothing smoothing = {};  ///< which pixels may be patches

  /// True if the height of a sky ray may be a polynomial of degree 1.
  [[nodiscard]] bool smooths_sky(const View<>& view) const {
    return square(view.pixel / 2) <= smoothing.most_normal_error;
  }
};

/// A pixel of a picture, counted from its left and its upper edge.
struct Pixel {
  int column, row;
};

/// Pixels in three lists. Packs take neighbors of a list, wherever they are in the picture.
struct PixelLists {
  std::vector<Pixel> misses;   ///< every ray misses the sphere
  std::vector<Pixel> patches;  ///< every ray meets it where it is smooth enough
  std::vector<Pixel> others;
};

/// With fewer samples per pixel than this, a patch costs more than it saves.
inline constexpr int least_samples_of_patch = 32;

/// Adds the pixels of a row, each to its list; the result is the same for any number of lanes.
///
/// @param scene   with one sphere, if there are bounds
/// @param bounds  nothing: all pixels are `others`
template <class Real, class Scene>
void add_row(PixelLists& lists, int row, int width, const Scene& scene,
             const std::optional<ViewBounds>& bounds) {
  constexpr int step = static_cast<int>(lanes<Real>);
  const std::array kinds{&lists.others, &lists.patches, &lists.misses};
  for (int first = 0; first < width; first += step) {
    std::array<Scalar<Real>, lanes<Real>> kind{};
    if (bounds) {
      const Real columns = from_lanes<Real>(
          [&](std::size_t i) { return static_cast<Scalar<Real>>(first + static_cast<int>(i)); });
      const PixelProbe<Real> look =
          probe_pixel(scene.view, scene.objects.front().shape, columns, Real(row));
      Mask<Real> smooth = look.curvature_error <= Real(bounds->smoothing.most_curvature_error);
      if (!scene.sky.is_constant())
        smooth = smooth && look.normal_error <= Real(bounds->smoothing.most_normal_error);
      kind = all_lanes(select(look.misses, Real(2), select(smooth, Real(1), Real(0))));
    }
    for (int i = 0; i < std::min(step, width - first); ++i) {
      kinds[static_cast<std::size_t>(kind[static_cast<std::size_t>(i)])]->push_back(
          {first + i, row});
    }
  }
}

}  // namespace texmap
