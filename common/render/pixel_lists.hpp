// The pixels of some rows, sorted by what their samples need.
#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "color.hpp"
#include "pixel_look.hpp"
#include "screen_bounds.hpp"

namespace texmap {

/// What is known of the picture of a lone sphere before a sample is drawn.
struct Foresight {
  ScreenBounds objects;      ///< outside of this part of the picture there is nothing but sky,
  std::optional<Rgb> light;  ///< of this light, if it is the same for every sample
  Smoothing smoothing = {};  ///< what may be patches

  /// True where a sky that changes may be taken from a polynomial of the first degree.
  [[nodiscard]] bool smooths_sky(const View& view) const { return square(view.pixel / 2) <= smoothing.most_tilt; }
};

/// A pixel of a picture, counted from its left and its upper edge.
struct Pixel {
  int column, row;
};

/// Pixels, each in one list. Those of a list are drawn alike: packs take them from it wherever they lie.
struct PixelLists {
  std::vector<Pixel> beside;   ///< no ray meets the sphere
  std::vector<Pixel> patches;  ///< every ray meets it where it is smooth enough
  std::vector<Pixel> others;
};

/// Fewer samples a pixel than this take less time than its patch does.
inline constexpr int least_samples_of_patch = 32;

/// Adds the pixels of a row, all to the others.
inline void add_row(PixelLists& lists, int row, int width) {
  for (int column = 0; column < width; ++column) lists.others.push_back({column, row});
}

/// Adds the pixels of a row, sorted.
///
/// @param scene  of the sphere that the foresight speaks of
/// Each pixel is judged by itself: the lists are the same for any number of lanes.
template <class Real, class Scene>
void add_row(PixelLists& lists, int row, int width, const Scene& scene, const Foresight& foresight) {
  constexpr int step = static_cast<int>(lanes<Real>);
  const Span span = foresight.objects.columns(row, width);
  for (int column = 0; column < width; ++column) {
    if (column < span.first || column >= span.end) lists.beside.push_back({column, row});
  }
  const std::array kinds{&lists.others, &lists.patches, &lists.beside};
  for (int first = span.first; first < span.end; first += step) {
    const Real columns =
        from_lanes<Real>([&](std::size_t i) { return static_cast<Scalar<Real>>(first + static_cast<int>(i)); });
    const PixelLook<Real> look = look_through(scene.view, scene.objects.front().sphere, columns, Real(row));
    Mask<Real> smooth = look.bend <= Real(foresight.smoothing.most_bend);
    if (!scene.sky.is_constant()) smooth = smooth && look.tilt <= Real(foresight.smoothing.most_tilt);
    const auto kind = all_lanes(select(look.beside, Real(2), select(smooth, Real(1), Real(0))));
    for (int i = 0; i < std::min(step, span.end - first); ++i) {
      kinds[static_cast<std::size_t>(kind[static_cast<std::size_t>(i)])]->push_back({first + i, row});
    }
  }
}

}  // namespace texmap
