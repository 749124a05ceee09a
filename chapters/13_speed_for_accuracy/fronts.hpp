// The error and the time of chapter 09's texture filters and of chapter 12's ways to use a sky as
// light.
#pragma once
#include <string>
#include <vector>

#include "12_environment_map/front.hpp"
#include "trials.hpp"

namespace texmap::chapter_13 {

/// A filter of chapter 09 on checkers to the horizon.
struct FilterCost {
  std::string name;
  std::string options;     ///< of chapter 09's program: --filter anisotropic --taps 4
  double error = 0;        ///< root mean square, of light 0 to 1
  double reads = 0;        ///< texels read a pixel
  double nanoseconds = 0;  ///< a look-up in double, on one thread: the shortest of all rounds
  double own_error = 0;    ///< as `error`, but against the filter's own ideal
  double spread = 1;       ///< of the time: WorkTime

  /// The error in levels of light, of which white has 255.
  [[nodiscard]] double levels() const { return 255 * error; }
};

/// A way and its samples under one of chapter 12's skies.
using SkyCost = chapter_12::SkyFigures;

/// The figures of both chapters.
struct Fronts {
  std::vector<FilterCost> filters;
  std::vector<SkyCost> skies;  ///< sky by sky, in it way by way
  std::string choice;          ///< how far one direction is off under each sky
  double rays = 0;             ///< that were followed for all of them
};

/// How many parts of a run the errors of filters and of skies are, and how many works are timed.
inline constexpr std::size_t filter_error_ticks = 1;
inline constexpr std::size_t sky_error_ticks =
    std::size_t{chapter_12::skies_compared} * (1 + chapter_12::figures_of_a_sky);
inline constexpr std::size_t filters_timed = 9;
inline constexpr std::size_t skies_timed =
    std::size_t{chapter_12::skies_compared} * chapter_12::figures_of_a_sky;

/// Measures both: errors first, which depend neither on the clock nor on the threads, then times,
/// taken alternately on one thread.
[[nodiscard]] Fronts measure_fronts(int threads, Timing& timing);

}  // namespace texmap::chapter_13
