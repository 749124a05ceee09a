// The pixels of some rows, sorted by how their samples are drawn.
#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "engine/render/smoothing/pixel_probe.hpp"
#include "engine/render/smoothing/screen_bounds.hpp"
#include "math/color.hpp"

namespace texmap {

/// What is known of the picture of a lone sphere before a sample is drawn.
struct ViewBounds {
  ScreenBounds objects;      ///< outside there is only sky
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

/// Adds the pixels of a row to `others`.
inline void add_row(PixelLists& lists, int row, int width) {
  for (int column = 0; column < width; ++column) lists.others.push_back({column, row});
}

/// Adds the pixels of a row, each to its list; the result is the same for any number of lanes.
///
/// @param scene  with the sphere of the ViewBounds
template <class Real, class Scene>
void add_row(PixelLists& lists, int row, int width, const Scene& scene,
             const ViewBounds& view_bounds) {
  constexpr int step = static_cast<int>(lanes<Real>);
  const Span span = view_bounds.objects.columns(row, width);
  for (int column = 0; column < width; ++column) {
    if (column < span.first || column >= span.end) lists.misses.push_back({column, row});
  }
  const std::array kinds{&lists.others, &lists.patches, &lists.misses};
  for (int first = span.first; first < span.end; first += step) {
    const Real columns = from_lanes<Real>(
        [&](std::size_t i) { return static_cast<Scalar<Real>>(first + static_cast<int>(i)); });
    const PixelProbe<Real> look =
        probe_pixel(scene.view, scene.objects.front().shape, columns, Real(row));
    Mask<Real> smooth = look.curvature_error <= Real(view_bounds.smoothing.most_curvature_error);
    if (!scene.sky.is_constant())
      smooth = smooth && look.normal_error <= Real(view_bounds.smoothing.most_normal_error);
    const auto kind = all_lanes(select(look.misses, Real(2), select(smooth, Real(1), Real(0))));
    for (int i = 0; i < std::min(step, span.end - first); ++i) {
      kinds[static_cast<std::size_t>(kind[static_cast<std::size_t>(i)])]->push_back(
          {first + i, row});
    }
  }
}

}  // namespace texmap
