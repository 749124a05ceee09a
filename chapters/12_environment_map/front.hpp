// The front of error against time: five ways to light matte objects by three skies.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "engine/measure/interleaved.hpp"

namespace texmap::chapter_12 {

/// A way to light the chapter's matte objects by one of the skies, with so many samples per pixel.
struct SkyFigures {
  std::string sky;  ///< uniform, gradient or sun
  std::string way;  ///< as the option --light has it
  int samples = 1;
  double error = 0;         ///< root mean square, in levels of 255
  double microseconds = 0;  ///< for a pixel, on one thread; 0: not timed
  bool chosen = false;      ///< the way that `--light auto` takes under this sky
  double spread = 1;        ///< of the time: WorkTime
};

/// What compare_skies found, and what there is to time.
struct SkyComparison {
  std::vector<SkyFigures> figures;  ///< sky by sky, in it way by way
  std::vector<Work> works;          ///< of each of the figures: a small picture on one thread
  std::string choice;               ///< how far one direction is off under each sky
  double paths = 0;                 ///< that were followed for the errors

  /// Notes what the works took.
  void note_times(const std::vector<WorkTime>& times);
};

/// How many skies, and how many figures for each.
inline constexpr int skies_compared = 3;
inline constexpr int figures_of_a_sky = 15;
/// Sizes of the pictures for errors and of those that are timed, and the samples of the reference.
inline constexpr int front_width = 80, front_height = 45;
inline constexpr int timed_width = 40, timed_height = 22;
inline constexpr int front_reference_samples = 2048;

/// The errors of all ways under a constant sky, a gradient and the chapter's own sky with a sun, in
/// packs of double. The reference is drawn by the way that `--light auto` takes, in packs of float.
///
/// @param threads  0: all cores; the errors do not depend on it
/// @param tick     called for each sky's reference and for each of the figures; may be empty
/// Errors: FileError if sky.hdr cannot be read.
[[nodiscard]] SkyComparison compare_skies(int threads, const std::function<void()>& tick = {});

}  // namespace texmap::chapter_12
