// The noise of sampled pictures: every sampler with ever more samples, how far off it is, and how long it takes.
#pragma once
#include <cmath>
#include <span>

#include "sampling_options.hpp"
#include "trials.hpp"

namespace texmap::chapter_13 {

/// A sampler with a number of samples a pixel.
struct Noise {
  SamplerKind kind = SamplerKind::random;
  int samples = 1;
  double rmse = 0;          ///< root mean square error over pixels and channels, levels of 255; the mean of all views
  double rmse_bound = 0;    ///< not exceeded by another seed and another view; see bound_of
  double milliseconds = 0;  ///< for one picture, on one thread: the shortest of all rounds
};

inline constexpr std::array<SamplerKind, 4> sampler_kinds = {SamplerKind::random, SamplerKind::stratified,
                                                             SamplerKind::multi_jitter, SamplerKind::sobol};
inline constexpr std::array<int, 5> sample_counts = {1, 4, 16, 64, 256};

/// Where the views of the noise stand round the globe: each sees another part of the picture.
inline constexpr int noise_views = 8;
inline constexpr int noise_width = 80;
inline constexpr int noise_height = 60;
/// Samples of the pictures that judge. Their own noise is in all figures, and makes them larger.
inline constexpr int converged_samples = 1024;

[[nodiscard]] inline View noise_view(const Globe& globe, int view) {
  return globe.view(noise_width, noise_height, 45 * view, view % 2 == 0 ? 25 : -25);
}

/// The light that a view shows, gathered with a number's packs.
[[nodiscard]] inline Film sampled(const Globe& globe, const View& view, const Way& way, const Sampler& sampler, int threads) {
  Film film(view.width, view.height);
  const int half = sampler.samples() / 2;
  const SampledShot shot(globe, mapping_of_degree(way.degree), way.texels, {sampler, half, &film});
  (void)draw_in_way(shot, view, way, threads);
  film.count(half, sampler.samples() - half);
  return film;
}

/// The light of a film as levels of 255 on the sRGB curve, not rounded to bytes.
[[nodiscard]] inline std::vector<double> levels_of(const Film& film) {
  std::vector<double> levels;
  for (int row = 0; row < film.height(); ++row) {
    for (int column = 0; column < film.width(); ++column) {
      const Rgb light = film.light(column, row);
      for (const double channel : {light.r, light.g, light.b}) levels.push_back(255 * srgb_encode(channel));
    }
  }
  return levels;
}

/// Root mean square difference of two pictures.
[[nodiscard]] inline double rms_apart(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += square(a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// What another view of the globe by another seed does not exceed: the mean of those seen and 6 standard deviations.
///
/// For errors that are spread normally, one more than `noise_views` = 8 exceeds it with a chance of 1 in 2600: Student's
/// distribution with 7 degrees of freedom at 6 / sqrt(1 + 1/8).
[[nodiscard]] inline double bound_of(const std::vector<double>& errors) {
  double mean = 0, squares = 0;
  for (const double error : errors) mean += error / static_cast<double>(errors.size());
  for (const double error : errors) squares += square(error - mean);
  return mean + 6 * std::sqrt(squares / static_cast<double>(errors.size() - 1));
}

/// The errors of all samplers, each view with a seed of its own.
///
/// @param way     number, instructions and kernel to draw with
/// @param counts  of samples a pixel
[[nodiscard]] inline std::vector<Noise> measure_noise(const Globe& globe, const Way& way, int threads, const Tick& tick,
                                                      std::span<const int> counts = sample_counts) {
  std::vector<std::vector<double>> judges;
  for (int i = 0; i < noise_views; ++i) {
    const Sampler converged(SamplerKind::sobol, converged_samples, 1000U + static_cast<std::uint32_t>(i));
    judges.push_back(levels_of(sampled(globe, noise_view(globe, i), way, converged, threads)));
    tick();
  }
  std::vector<Noise> all;
  for (const SamplerKind kind : sampler_kinds) {
    for (const int samples : counts) {
      std::vector<double> errors;
      for (int i = 0; i < noise_views; ++i) {
        const Sampler sampler(kind, samples, static_cast<std::uint32_t>(i));
        const auto levels = levels_of(sampled(globe, noise_view(globe, i), way, sampler, threads));
        errors.push_back(rms_apart(levels, judges[static_cast<std::size_t>(i)]));
      }
      double mean = 0;
      for (const double error : errors) mean += error / noise_views;
      all.push_back({kind, samples, mean, bound_of(errors)});
      tick();
    }
  }
  return all;
}

/// How many rounds the samplers are timed: they take longer, and their ratios are larger.
[[nodiscard]] inline int noise_rounds(int rounds) { return rounds / 4 + 1; }

/// Fills in the times of all samplers, taken by turns on one thread.
inline void time_noise(std::vector<Noise>& all, const Globe& globe, const Way& way, Timing& timing) {
  const View view = noise_view(globe, 0);
  std::vector<Work> works;
  works.reserve(all.size());
  for (const Noise& noise : all) {
    works.emplace_back(
        [&globe, &view, &way, sampler = Sampler(noise.kind, noise.samples)] { (void)sampled(globe, view, way, sampler, 1); });
  }
  const auto shortest = timed_by_turns(works, noise_rounds(timing.rounds), works.size(), timing);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].milliseconds = shortest[i];
}

/// Samples of the pictures in which both ways to keep texels are tried once more: there texels take more of the time.
inline constexpr int kept_samples = 64;

/// Both ways to keep texels with every number, the first plain double's bytes.
[[nodiscard]] inline std::vector<Trial> all_kept(Instructions widest) {
  std::vector<Trial> trials;
  for (const auto& [number, instructions] : numbers_of_light(widest)) {
    for (const Texels texels : {Texels::bytes, Texels::roots}) {
      trials.push_back({{number, instructions, 0, Filter::nearest, Curve::exact, texels}, {}});
    }
  }
  return trials;
}

/// How far off the levels and the bytes of a sampled picture are, and how far they can be. The judge is the same picture, by
/// the same samples in the same number, of texels kept as bytes.
[[nodiscard]] inline Errors errors_of_kept(const Globe& globe, const View& view, const Way& way, const Sampler& sampler,
                                           int threads) {
  Way of_bytes = way;
  of_bytes.texels = Texels::bytes;
  const Film film = sampled(globe, view, way, sampler, threads);
  const Film judge = sampled(globe, view, of_bytes, sampler, threads);
  const std::vector<double> levels = levels_of(film);
  const std::vector<double> right = levels_of(judge);
  Errors errors;
  state_levels(way, sampler.samples(), errors);
  for (std::size_t i = 0; i < levels.size(); i += 3) {
    errors.may_change += note_pixel({levels[i], levels[i + 1], levels[i + 2]}, {right[i], right[i + 1], right[i + 2]}, errors);
  }
  errors.mean_unrounded /= static_cast<double>(levels.size());
  compare_bytes(develop(film, Transfer::srgb), develop(judge, Transfer::srgb), errors);
  return errors;
}

/// Both ways to keep texels with their errors in one view.
[[nodiscard]] inline std::vector<Trial> judged_kept(const Globe& globe, Instructions widest, int threads, const Tick& tick) {
  std::vector<Trial> trials = all_kept(widest);
  for (Trial& trial : trials) {
    trial.errors = errors_of_kept(globe, noise_view(globe, 0), trial.way, Sampler(SamplerKind::sobol, kept_samples), threads);
    tick();
  }
  return trials;
}

/// Tries both ways to keep texels: judged, and timed by turns on one thread.
[[nodiscard]] inline std::vector<Trial> try_kept(const Globe& globe, Instructions widest, int threads, Timing& timing) {
  const View view = noise_view(globe, 0);
  const Sampler sampler(SamplerKind::sobol, kept_samples);
  std::vector<Trial> trials = judged_kept(globe, widest, threads, timing.tick);
  std::vector<Work> works;
  works.reserve(trials.size());
  for (const Trial& trial : trials) {
    works.emplace_back([&globe, &view, &sampler, &way = trial.way] { (void)sampled(globe, view, way, sampler, 1); });
  }
  const auto shortest = timed_by_turns(works, noise_rounds(timing.rounds), works.size(), timing);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    trials[i].milliseconds = shortest[i];
    trials[i].time = shortest[i] / shortest[0];
  }
  return trials;
}

}  // namespace texmap::chapter_13
