// The trials: how far off every variant is, and how long it takes.
#include "trials.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "engine/compare/difference.hpp"
#include "engine/measure/text.hpp"
#include "math/srgb.hpp"

namespace texmap::chapter_13 {

void compare_bytes(const Image& image, const Image& reference, Errors& errors) {
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const int levels = channel_difference(image.pixels[i], reference.pixels[i]);
    errors.changed += levels > 0 ? 1 : 0;
    errors.levels = std::max(errors.levels, levels);
  }
}

void find_errors_of_places(std::vector<Trial>& trials, const Globe& globe, const View<>& view,
                           const Tick& tick) {
  const auto hits = reference_hits(globe, view);
  const std::array references = {reference_picture(globe, view, Filter::nearest),
                                 reference_picture(globe, view, Filter::bilinear)};
  for (Trial& trial : trials) {
    Variant first = trial.variant;
    first.instructions = Instructions::baseline;
    const Trial* same = find_trial(trials, first);
    trial.errors = same != &trial
                       ? same->errors
                       : errors_of_places(globe, view, trial.variant, hits,
                                          references[static_cast<std::size_t>(first.filter)]);
    tick();
  }
}

void find_errors_of_curves(std::vector<Trial>& trials, const Globe& globe, const View<>& view,
                           const Tick& tick) {
  for (Trial& trial : trials) {
    trial.errors = errors_of_light(globe, view, trial.variant);
    tick();
  }
}

std::vector<double> levels_of(const Film& film) {
  std::vector<double> levels;
  for (int row = 0; row < film.height(); ++row) {
    for (int column = 0; column < film.width(); ++column) {
      const Rgb light = film.light(column, row);
      for (const double channel : {light.r, light.g, light.b})
        levels.push_back(255 * srgb_encode(channel));
    }
  }
  return levels;
}

std::vector<WorkTime> timed_alternately(const std::vector<Work>& works, int rounds,
                                        std::size_t ticks, Timing& timing) {
  Rounds& noted = timing.done.emplace_back(Rounds{rounds});
  auto times = work_times(
      works, rounds,
      [&](int done, int) {
        if (static_cast<std::size_t>(done - 1) % works.size() < ticks) timing.tick();
      },
      [&](int round) {
        noted.timed = round;
        return timing.limit(round);
      });
  for (std::size_t i = 0; i < ticks * static_cast<std::size_t>(rounds - noted.timed); ++i)
    timing.tick();
  return times;
}

void time_trials(std::vector<Trial>& trials, const Globe& globe, const View<>& view,
                 Timing& timing) {
  std::vector<Work> works;
  std::vector<std::size_t> trial_of_run;
  const auto add = [&](std::size_t i) {
    works.emplace_back(
        [&globe, &view, variant = trials[i].variant] { (void)picture_of(globe, view, variant); });
    trial_of_run.push_back(i);
  };
  for (std::size_t i = 0; i < trials.size(); ++i) {
    add(i);
    if (i % 10 != 9) continue;
    // All others are measured by the first, so it and its like with the other filter are timed more
    // often: if they were disturbed in all rounds, every figure would be wrong. Their time is
    // rather too short: nothing is called faster than it is.
    for (std::size_t k = 0; k < trials.size(); ++k) {
      const Variant& variant = trials[k].variant;
      if (variant.number == NumberKind::double_ && variant.degree == 0 &&
          variant.curve == trials[0].variant.curve)
        add(k);
    }
  }
  const auto times = timed_alternately(works, timing.rounds, trials.size(), timing);
  for (Trial& trial : trials) trial.took = {};
  for (std::size_t k = 0; k < works.size(); ++k) {
    WorkTime& took = trials[trial_of_run[k]].took;
    if (times[k].processor < took.processor) took = times[k];
  }
  for (Trial& trial : trials) trial.time = trial.took.processor / trials[0].took.processor;
}

WorkTime time_alone(const Globe& globe, const View<>& view) {
  const std::vector<Work> work = {[&] { (void)picture_of(globe, view, {}); }};
  return work_times(work, rounds_within(200, work, 7, 100)).front();
}

bool agree(const WorkTime& a, const WorkTime& b) {
  const double longer = std::max(a.processor, b.processor);
  return longer < 1 || longer <= 1.25 * std::min(a.processor, b.processor);
}

void require_agreement(const WorkTime& alone, const WorkTime& among) {
  if (agree(alone, among)) return;
  throw std::runtime_error(
      text("plain double took %.1f ms for a picture before packs were timed, and %.1f ms among "
           "them. Every ratio would be wrong, so none is shown. Either this machine changed its "
           "speed meanwhile: run again when nothing else runs. Or packs leave the processor in a "
           "state that slows plain numbers: with --instructions baseline both times are then equal",
           alone.processor, among.processor));
}

void time_trials_beside(const WorkTime& alone, std::vector<Trial>& trials, const Globe& globe,
                        const View<>& view, Timing& timing) {
  WorkTime base = alone;
  const auto first = timing.done.size();
  for (int attempt = 0; attempt < 3; ++attempt) {
    timing.done.resize(first);
    time_trials(trials, globe, view, timing);
    if (agree(base, trials[0].took)) return;
    // The machine may have been slow at the start. What wide code does to plain numbers lasts.
    base.processor = std::min(base.processor, time_alone(globe, view).processor);
    if (agree(base, trials[0].took)) return;
  }
  require_agreement(base, trials[0].took);
}

}  // namespace texmap::chapter_13
