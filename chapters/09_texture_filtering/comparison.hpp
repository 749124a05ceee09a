// What the filters cost and how far off they are, on checkers to the horizon.
#pragma once
#include <string>
#include <vector>

#include "scene/camera.hpp"
#include "scene/floor.hpp"
#include "texture/filters.hpp"
#include "texture/floor_mapping.hpp"
#include "texture/rotated.hpp"

namespace texmap {
struct Plot;
}  // namespace texmap

namespace texmap::chapter_09 {

/// A floor, and who looks at it.
struct FloorView {
  Camera camera;
  Floor floor;
  Rotated<FloorMapping> mapping;
};

/// A filter and its figures.
struct FilterFigures {
  Filter filter;
  int taps;
  std::string name;
  double error = 0;        ///< root mean square, of light 0 to 1, against the mean over the pixel
  double own_error = 0;    ///< the same against ideal_light: what the pyramid costs, or noise
  double reads = 0;        ///< texels read a pixel
  double nanoseconds = 0;  ///< a look-up in double on one thread; 0: not timed
};

/// The size of the picture.
inline constexpr int comparison_width = 192;
inline constexpr int comparison_height = 96;

/// The filters with their errors and reads, on a floor of checkers. The mean over a pixel is that
/// of 1,597 places.
///
/// @param threads  0: all cores; the figures do not depend on it
/// @param timed    also measures the time
[[nodiscard]] std::vector<FilterFigures> compare_filters(const FloorView& scene, int threads,
                                                         bool timed);

/// The figures as the chapter prints them.
[[nodiscard]] std::string table_of_filters(const std::vector<FilterFigures>& figures);

/// Error against reads.
[[nodiscard]] Plot plot_of_filters(const std::vector<FilterFigures>& figures);

}  // namespace texmap::chapter_09
