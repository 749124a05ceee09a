// What the filters cost and how far off they are, on checkers to the horizon.
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "scene/camera.hpp"
#include "scene/floor.hpp"
#include "texture/filters.hpp"
#include "texture/floor_mapping.hpp"
#include "texture/rotated.hpp"

namespace texmap {
struct Plot;
struct WorkTime;
}  // namespace texmap

namespace texmap::chapter_09 {

/// A floor, and who looks at it; this chapter's, unless something else is said. (The lesson's own
/// numbers once more: chapter 13 compares filters without its program, and a test compares both.)
struct FloorView {
  Camera camera{.eye = {0, 1, 0}, .target = {0, 0.62, -2}, .fov_y_degrees = 50};
  Floor floor{.height = 0};
  Rotated<FloorMapping> mapping{rotation_y(23), {.size = 8}};
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
  double spread = 1;       ///< of that time: WorkTime
};

/// Filters with their figures, and what there is to time.
struct FilterComparison {
  std::vector<FilterFigures> figures;
  /// To be timed, of each of the figures: `look_ups` look-ups on one thread.
  std::vector<std::function<void()>> works;
  std::size_t look_ups = 0;  ///< one for each pixel of the floor
  double rays = 0;           ///< that were followed for the errors

  /// Notes what the works took.
  void note_times(const std::vector<WorkTime>& times);
};

/// How many filters are compared, and the size of the picture.
inline constexpr int filters_compared = 9;
inline constexpr int comparison_width = 192;
inline constexpr int comparison_height = 96;

/// The filters with their errors and reads, on a floor of checkers; not timed. The mean over a
/// pixel is that of 1,597 places.
///
/// @param threads  0: all cores; the figures do not depend on it
[[nodiscard]] FilterComparison filter_comparison(const FloorView& scene, int threads);

/// The figures of the same.
///
/// @param timed  also measures the time
[[nodiscard]] std::vector<FilterFigures> compare_filters(const FloorView& scene, int threads,
                                                         bool timed);

/// The figures as the chapter prints them.
[[nodiscard]] std::string table_of_filters(const std::vector<FilterFigures>& figures);

/// Error against reads.
[[nodiscard]] Plot plot_of_filters(const std::vector<FilterFigures>& figures);

}  // namespace texmap::chapter_09
