// Pictures of many samples: the noise of every sampler, and both texel formats.
#pragma once
#include <array>
#include <span>

#include "trials.hpp"

namespace texmap::chapter_13 {

/// A sampler with a number of samples per pixel. Errors are root mean squares over pixels and
/// channels, in levels of 255.
struct Noise {
  SamplerKind kind = SamplerKind::random;
  int samples = 1;
  double rmse = 0;            ///< the mean of all views
  double rmse_bound = 0;      ///< not exceeded by another seed and another view; see noise_bound
  WorkTime took = {0, 0, 1};  ///< for one picture, on one thread
};

inline constexpr std::array sampler_kinds = {SamplerKind::random, SamplerKind::stratified,
                                             SamplerKind::multi_jitter, SamplerKind::sobol};
inline constexpr std::array sample_counts = {1, 4, 16, 64, 256};

/// The views of the noise, each of another part of the globe.
inline constexpr int noise_views = 8;
inline constexpr int noise_width = 80;
inline constexpr int noise_height = 60;
/// Samples of the reference pictures. Their own noise is in all figures, and makes them larger.
inline constexpr int converged_samples = 1024;
/// Samples of the pictures that compare texel formats: there texels take more of the time.
inline constexpr int texel_format_samples = 64;

/// How many rounds sampled pictures are timed: they take longer, and their ratios are larger.
[[nodiscard]] inline int noise_rounds(int rounds) { return rounds / 4 + 1; }

/// Root mean square difference of two pictures' levels.
[[nodiscard]] double rms_difference(const std::vector<double>& a, const std::vector<double>& b);

/// What another view by another seed does not exceed: the mean of those seen and 6 standard
/// deviations.
///
/// For normally distributed errors one more than `noise_views` = 8 exceeds it with a chance of 1 in
/// 2600: Student's distribution with 7 degrees of freedom at 6 / sqrt(1 + 1/8).
[[nodiscard]] double noise_bound(const std::vector<double>& errors);

/// The errors of all samplers, each view with a seed of its own.
///
/// @param variant  number, instructions and kernel to draw with
/// @param counts   of samples per pixel
[[nodiscard]] std::vector<Noise> measure_noise(const Globe& globe, const Variant& variant,
                                               int threads, const Tick& tick,
                                               std::span<const int> counts = sample_counts);
/// Fills in the times of all samplers, taken alternately on one thread.
void time_noise(std::vector<Noise>& all, const Globe& globe, const Variant& variant,
                Timing& timing);

/// Both texel formats with their errors in one view.
[[nodiscard]] std::vector<Trial> measure_texel_formats(const Globe& globe, Instructions widest,
                                                       int threads, const Tick& tick);
/// Fills in their times, taken alternately on one thread.
void time_texel_formats(std::vector<Trial>& trials, const Globe& globe, Timing& timing);

}  // namespace texmap::chapter_13
