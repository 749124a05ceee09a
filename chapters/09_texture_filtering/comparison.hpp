// What the filters cost and how far off they are, on checkers to the horizon.
#pragma once
#include <string>
#include <vector>

#include "engine/measure/plot.hpp"
#include "texture/filters.hpp"

namespace texmap::chapter_09 {

/// A filter and its figures.
struct FilterFigures {
  Filter filter;
  int taps;
  std::string name;
  double error = 0;        ///< root mean square, of light 0 to 1, against the mean over the pixel
  double reads = 0;        ///< texels read a pixel
  double nanoseconds = 0;  ///< a look-up in double on one thread; 0: not timed
};

/// The filters with their errors and reads, on a floor of checkers, 192 x 96 pixels with the
/// lesson's camera; the mean over a pixel is that of 64 x 64 places.
///
/// @param threads  0: all cores
/// @param timed    also measures the time
[[nodiscard]] std::vector<FilterFigures> compare_filters(int threads, bool timed);

/// The figures as the chapter prints them.
[[nodiscard]] std::string table_of_filters(const std::vector<FilterFigures>& figures);

/// Error against reads.
[[nodiscard]] Plot plot_of_filters(const std::vector<FilterFigures>& figures);

}  // namespace texmap::chapter_09
