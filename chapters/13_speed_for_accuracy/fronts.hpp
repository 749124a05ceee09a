// The four plots of this chapter: speed against error of places and of levels, error against samples, error against seconds.
#pragma once
#include <optional>

#include "front.hpp"
#include "plot.hpp"
#include "table.hpp"

namespace texmap::chapter_13 {

/// The front as a plot shows it: of neighbours that are as fast the most exact alone has a label.
///
/// @param label  called with an index, gives what is written there
template <class Label>
[[nodiscard]] std::vector<PlotPoint> labelled_front(const std::vector<Tradeoff>& tradeoffs, const Label& label) {
  std::vector<PlotPoint> points;
  for (const Tradeoff& next : front_of(tradeoffs)) {
    if (!points.empty() && next.time < same_time * points.back().x) points.back().label.clear();
    points.push_back({next.time, next.error, label(next.index)});
  }
  return points;
}

/// The styles of the samplers.
inline constexpr std::array<int, 4> sampler_styles = {0, 4, 8, 1};

/// Adds a point to the series of what a way calculates with, and the series to the plot if it is the first.
inline void add_point(Plot& plot, const Way& way, const PlotPoint& point) {
  const std::string name = described_number(way);
  const auto is_named = [&name](const PlotSeries& each) { return each.name == name; };
  if (std::none_of(plot.series.begin(), plot.series.end(), is_named)) {
    plot.series.push_back({name, static_cast<int>(plot.series.size()) % 9, {}});
  }
  std::find_if(plot.series.begin(), plot.series.end(), is_named)->points.push_back(point);
}

/// What a plot of trials shows of one of them.
struct ShownTrial {
  double off = 0;     ///< how far off it is at most
  std::string label;  ///< at its point; none if it has no text
};

/// The times of trials against how far off they are: a series for each number, and the front of all.
///
/// @param show   called with a trial, gives an optional ShownTrial: nothing where the trial stays out of the plot
/// @param label  called with the way of a trial on the front, gives what is written there
template <class Show, class Label>
void add_trials(Plot& plot, const std::vector<Trial>& trials, const Show& show, const Label& label) {
  std::vector<Tradeoff> tradeoffs;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const Trial& trial = trials[i];
    const std::optional<ShownTrial> shown = show(trial);
    if (!shown) continue;
    tradeoffs.push_back({trial.time, shown->off, i});
    add_point(plot, trial.way, {trial.time, shown->off, shown->label});
  }
  plot.front = labelled_front(tradeoffs, [&](std::size_t i) { return label(trials[i].way); });
}

/// Every number and kernel with the nearest texel: its time, and how far off a place can be at most.
[[nodiscard]] inline Plot plot_speed_error(const Measurements& all) {
  Plot plot{"Speed against error: places on the texture, one ray a pixel",
            "time, plain double with the reference formula = 1",
            "a place is off by at most, in texels",
            {},
            {},
            {}};
  const auto show = [&all](const Trial& trial) -> std::optional<ShownTrial> {
    if (trial.way.filter != Filter::nearest) return {};
    return ShownTrial{trial.errors.texels_bound, &trial == &all.places.front() ? "plain double" : ""};
  };
  add_trials(plot, all.places, show, [](const Way& way) { return name_of_kernel(way.degree); });
  return plot;
}

/// Every curve and both ways to keep texels: the time, and how far off a channel can be at most, of which the rounding to bytes
/// is half a level.
[[nodiscard]] inline Plot plot_speed_levels(const Measurements& all) {
  Plot plot{"Speed against error: from texels through light to bytes, one ray a pixel",
            "time, plain double with the power = 1",
            "a channel is off by at most, in levels of 255, rounding included",
            {},
            {},
            {}};
  const auto show = [](const Trial& trial) -> std::optional<ShownTrial> {
    return ShownTrial{0.5 + trial.errors.unrounded_bound,
                      trial.way.number == Number::double_ ? described_light(trial.way) : ""};
  };
  add_trials(plot, all.curves, show, described_light);
  return plot;
}

/// The noise of each sampler against its samples.
[[nodiscard]] inline Plot plot_error_samples(const Measurements& all) {
  Plot plot{"Error against samples", "samples a pixel", "root mean square error, levels of 255", {}, {}, {}};
  for (const int samples : sample_counts) plot.x_ticks.push_back(samples);
  for (std::size_t k = 0; k < sampler_kinds.size(); ++k) {
    PlotSeries mean{name_of(sampler_kinds[k]), sampler_styles[k], {}, true};
    PlotSeries most{mean.name + ", at most", sampler_styles[k], {}, true, true};
    for (const Noise& noise : all.noise) {
      if (noise.kind != sampler_kinds[k]) continue;
      mean.points.push_back({1.0 * noise.samples, noise.rmse, {}});
      most.points.push_back({1.0 * noise.samples, noise.rmse_bound, {}});
    }
    mean.points.back().label = printed("%.2f", mean.points.back().y);
    plot.series.push_back(mean);
    plot.series.push_back(most);
  }
  return plot;
}

/// What the noise of each sampler does not exceed, against the time that it takes.
[[nodiscard]] inline Plot plot_error_seconds(const Measurements& all) {
  const std::string size = std::to_string(noise_width) + " x " + std::to_string(noise_height);
  Plot plot{"Error against seconds",
            "seconds for " + size + " pixels, " + described(all.exact) + ", one thread",
            "root mean square error at most, levels of 255",
            {},
            {},
            {}};
  std::vector<Tradeoff> tradeoffs;
  for (std::size_t k = 0; k < sampler_kinds.size(); ++k) {
    PlotSeries most{name_of(sampler_kinds[k]), sampler_styles[k], {}, true};
    for (std::size_t i = 0; i < all.noise.size(); ++i) {
      const Noise& noise = all.noise[i];
      if (noise.kind != sampler_kinds[k]) continue;
      most.points.push_back({noise.milliseconds / 1000, noise.rmse_bound, {}});
      tradeoffs.push_back({noise.milliseconds / 1000, noise.rmse_bound, i});
    }
    plot.series.push_back(most);
  }
  plot.front = labelled_front(
      tradeoffs, [&all](std::size_t i) { return printed("%s %d", name_of(all.noise[i].kind), all.noise[i].samples); });
  return plot;
}

}  // namespace texmap::chapter_13
