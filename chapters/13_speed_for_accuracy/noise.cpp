// Pictures of many samples: the noise of every sampler, and both texel formats.
#include "noise.hpp"

#include <cmath>
#include <numeric>

namespace texmap::chapter_13 {
namespace {

View<> noise_view(const Globe& globe, int view) {
  return globe.view(noise_width, noise_height, 45 * view, view % 2 == 0 ? 25 : -25);
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The times of pictures of the first view, taken alternately on one thread.
///
/// @param add  called with a function that takes a variant and a sampler of one more picture
template <class Add>
std::vector<WorkTime> time_pictures(const Globe& globe, Timing& timing, const Add& add) {
  const View<> view = noise_view(globe, 0);
  std::vector<Work> works;
  add([&](const Variant& variant, const Sampler& sampler) {
    works.emplace_back(
        [&globe, &view, variant, sampler] { (void)sampled(globe, view, variant, sampler, 1); });
  });
  return timed_alternately(works, noise_rounds(timing.rounds), works.size(), timing);
}

}  // namespace

double rms_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += square(a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

double noise_bound(const std::vector<double>& errors) {
  const double mean = mean_of(errors);
  double squares = 0;
  for (const double error : errors) squares += square(error - mean);
  return mean + 6 * std::sqrt(squares / static_cast<double>(errors.size() - 1));
}

std::vector<Noise> measure_noise(const Globe& globe, const Variant& variant, int threads,
                                 const Tick& tick, std::span<const int> counts) {
  const auto levels = [&](int view, SamplerKind kind, int samples, int seed) {
    const Sampler sampler(kind, samples, static_cast<std::uint32_t>(seed));
    return levels_of(sampled(globe, noise_view(globe, view), variant, sampler, threads));
  };
  std::vector<std::vector<double>> references;
  for (int i = 0; i < noise_views; ++i) {
    references.push_back(levels(i, SamplerKind::sobol, converged_samples, 1000 + i));
    tick();
  }
  std::vector<Noise> all;
  for (const SamplerKind kind : sampler_kinds) {
    for (const int samples : counts) {
      std::vector<double> errors;
      errors.reserve(noise_views);
      for (int i = 0; i < noise_views; ++i) {
        errors.push_back(
            rms_difference(levels(i, kind, samples, i), references[static_cast<std::size_t>(i)]));
      }
      all.push_back({kind, samples, mean_of(errors), noise_bound(errors)});
      tick();
    }
  }
  return all;
}

void time_noise(std::vector<Noise>& all, const Globe& globe, const Variant& variant,
                Timing& timing) {
  const auto times = time_pictures(globe, timing, [&](const auto& add) {
    for (const Noise& noise : all) add(variant, Sampler(noise.kind, noise.samples));
  });
  for (std::size_t i = 0; i < all.size(); ++i) all[i].took = times[i];
}

std::vector<Trial> measure_texel_formats(const Globe& globe, Instructions widest, int threads,
                                         const Tick& tick) {
  std::vector<Trial> trials = all_texel_formats(widest);
  for (Trial& trial : trials) {
    trial.errors = errors_of_samples(globe, noise_view(globe, 0), trial.variant,
                                     Sampler(SamplerKind::sobol, texel_format_samples), threads);
    tick();
  }
  return trials;
}

void time_texel_formats(std::vector<Trial>& trials, const Globe& globe, Timing& timing) {
  const auto times = time_pictures(globe, timing, [&](const auto& add) {
    for (const Trial& trial : trials)
      add(trial.variant, Sampler(SamplerKind::sobol, texel_format_samples));
  });
  for (std::size_t i = 0; i < trials.size(); ++i) {
    trials[i].took = times[i];
    trials[i].time = times[i].processor / times[0].processor;
  }
}

}  // namespace texmap::chapter_13
