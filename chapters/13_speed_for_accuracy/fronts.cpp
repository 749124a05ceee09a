// The error and the time of chapter 09's texture filters and of chapter 12's ways to use a sky as
// light.
#include "fronts.hpp"

#include "09_texture_filtering/comparison.hpp"
#include "noise.hpp"

namespace texmap::chapter_13 {
namespace {

static_assert(filters_timed == chapter_09::filters_compared);

/// The options that draw chapter 09's scene by a filter: "anisotropic 4" is a filter and its taps.
std::string options_of(const std::string& name) {
  const std::size_t space = name.find(' ');
  std::string options = std::string("--filter ") + name.substr(0, space);
  if (space != std::string::npos) options.append(" --taps ").append(name.substr(space + 1));
  return options;
}

}  // namespace

Fronts measure_fronts(int threads, Timing& timing) {
  Fronts all;
  chapter_09::FilterComparison filters = chapter_09::filter_comparison({}, threads);
  timing.tick();
  filters.note_times(timed_alternately(filters.works, timing.rounds, filters.works.size(), timing));
  for (const chapter_09::FilterFigures& one : filters.figures) {
    all.filters.push_back({one.name, options_of(one.name), one.error, one.reads, one.nanoseconds,
                           one.own_error, one.spread});
  }

  chapter_12::SkyComparison skies = chapter_12::compare_skies(threads, timing.tick);
  skies.note_times(
      timed_alternately(skies.works, noise_rounds(timing.rounds), skies.works.size(), timing));
  all.skies = skies.figures;
  all.choice = skies.choice;

  all.rays = filters.rays + skies.paths;
  for (const SkyCost& one : all.skies) {
    all.rays += 1.0 * chapter_12::timed_width * chapter_12::timed_height * one.samples *
                (timing.done.back().timed + 1);
  }
  return all;
}

}  // namespace texmap::chapter_13
