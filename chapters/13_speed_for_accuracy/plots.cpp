// The six plots of this chapter, and the front of what nothing else beats.
#include "plots.hpp"

#include <algorithm>

#include "engine/measure/text.hpp"

namespace texmap::chapter_13 {
namespace {

constexpr std::array sampler_styles = {0, 4, 8, 1};
constexpr std::array sky_styles = {6, 1, 5};

/// Times and errors of filters, or of the ways under one sky.
std::vector<Tradeoff> tradeoffs_of(const Fronts& fronts) {
  std::vector<Tradeoff> all;
  for (std::size_t i = 0; i < fronts.filters.size(); ++i)
    all.push_back({fronts.filters[i].nanoseconds, fronts.filters[i].levels(), i});
  return all;
}
std::vector<Tradeoff> tradeoffs_of(const Fronts& fronts, const std::string& sky) {
  std::vector<Tradeoff> all;
  for (std::size_t i = 0; i < fronts.skies.size(); ++i) {
    if (fronts.skies[i].sky == sky)
      all.push_back({fronts.skies[i].microseconds, fronts.skies[i].error, i});
  }
  return all;
}

/// Adds a point to the series of a variant's number; a new series if it is the first.
void add_point(Plot& plot, const Variant& variant, const PlotPoint& point) {
  const std::string name = described_number(variant);
  auto series = std::find_if(plot.series.begin(), plot.series.end(),
                             [&name](const PlotSeries& each) { return each.name == name; });
  if (series == plot.series.end())
    series = plot.series.insert(series, {name, static_cast<int>(plot.series.size()) % 9});
  series->points.push_back(point);
}

/// The times of trials against how far off they are at most: a series for each number, and the
/// front of all.
///
/// @param shows  whether a trial is in the plot
/// @param name   of a variant, besides its number
/// @param label  of a trial on its own, and what is written on the front
template <class Shows, class Bound, class Name, class Label, class FrontLabel>
void add_trials(Plot& plot, const std::vector<Trial>& trials, const Shows& shows,
                const Bound& bound, const Name& name, const Label& label,
                const FrontLabel& front_label) {
  std::vector<Tradeoff> tradeoffs;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const Trial& trial = trials[i];
    if (!shows(trial)) continue;
    tradeoffs.push_back({trial.time, bound(trial), i});
    add_point(plot, trial.variant,
              {trial.time, bound(trial), label(trial), trial.time * trial.took.spread,
               described_number(trial.variant) + ", " + name(trial.variant)});
  }
  plot.front =
      labelled_front(tradeoffs, [&](std::size_t i) { return front_label(trials[i].variant); });
}

/// A joined series of a sampler; `y` is a member of Noise, `x` called with one.
template <class X>
PlotSeries series_of(const Measurements& all, std::size_t kind, const X& x, double Noise::*y) {
  PlotSeries series{name_of(sampler_kinds[kind]), sampler_styles[kind], {}, true};
  for (const Noise& noise : all.noise) {
    if (noise.kind == sampler_kinds[kind]) series.points.push_back({x(noise), noise.*y, {}});
  }
  return series;
}

}  // namespace

std::vector<Tradeoff> pareto_front(std::vector<Tradeoff> all) {
  std::sort(all.begin(), all.end(), [](const Tradeoff& a, const Tradeoff& b) {
    return a.time < b.time || (a.time == b.time && a.error < b.error);
  });
  std::vector<Tradeoff> front;
  for (const Tradeoff& next : all) {
    if (front.empty() || next.error < front.back().error) front.push_back(next);
  }
  return front;
}

std::vector<PlotPoint> labelled_front(const std::vector<Tradeoff>& tradeoffs,
                                      const std::function<std::string(std::size_t)>& label) {
  std::vector<PlotPoint> points;
  for (const Tradeoff& next : pareto_front(tradeoffs)) {
    if (!points.empty() && next.time < same_time * points.back().x) points.back().label.clear();
    points.push_back({next.time, next.error, label(next.index)});
  }
  return points;
}

Plot plot_speed_error(const Measurements& all) {
  Plot plot{.title = "The trade: each way to draw the globe, its time and how far off it can be",
            .x_title = text("time of a picture, plain double with atan2 = 1 (%.1f ms); bars end at "
                            "the median",
                            all.places.front().took.processor),
            .y_title = "texels off at most; a number is a polynomial's degree"};
  // Of the polynomials some: what lies between them has a time between theirs.
  const auto shown = [](const Trial& trial) {
    constexpr std::array degrees = {0, 5, 9, 17, 23, 35};
    return trial.variant.filter == Filter::nearest &&
           std::find(degrees.begin(), degrees.end(), trial.variant.degree) != degrees.end();
  };
  const auto name = [](const Variant& variant) {
    return variant.degree == 0 ? std::string("atan2") : name_of_kernel(variant.degree);
  };
  add_trials(
      plot, all.places, shown, [](const Trial& trial) { return trial.errors.texels_bound; }, name,
      [&](const Trial& trial) {
        return trial.variant.degree == 0 ? std::string("atan2")
                                         : std::to_string(trial.variant.degree);
      },
      [](const Variant&) { return std::string(); });
  return plot;
}

Plot plot_speed_levels(const Measurements& all) {
  Plot plot{.title = "Speed against error: from texels through light to bytes, one ray a pixel",
            .x_title = "time, plain double with the power = 1",
            .y_title = "a channel is off by at most, in levels of 255, rounding included"};
  add_trials(
      plot, all.curves, [](const Trial&) { return true; },
      [](const Trial& trial) { return 0.5 + trial.errors.unrounded_bound; }, described_light,
      [](const Trial& trial) {
        return trial.variant.number == NumberKind::double_ ? described_light(trial.variant) : "";
      },
      described_light);
  return plot;
}

Plot plot_error_samples(const Measurements& all) {
  Plot plot{.title = "Error against samples",
            .x_title = "samples a pixel",
            .y_title = "root mean square error, levels of 255",
            .x_ticks = {sample_counts.begin(), sample_counts.end()}};
  const auto samples = [](const Noise& noise) { return double{1} * noise.samples; };
  for (std::size_t kind = 0; kind < sampler_kinds.size(); ++kind) {
    PlotSeries mean = series_of(all, kind, samples, &Noise::rmse);
    mean.points.back().label = text("%.2f", mean.points.back().y);
    PlotSeries most = series_of(all, kind, samples, &Noise::rmse_bound);
    most.name += ", at most";
    most.dashed = true;
    plot.series.insert(plot.series.end(), {mean, most});
  }
  return plot;
}

Plot plot_error_seconds(const Measurements& all) {
  Plot plot{.title = "Error against seconds",
            .x_title = text("seconds for %d x %d pixels, %s, one thread", noise_width, noise_height,
                            described(all.exact).c_str()),
            .y_title = "root mean square error at most, levels of 255"};
  const auto seconds = [](const Noise& noise) { return noise.took.processor / 1000; };
  for (std::size_t kind = 0; kind < sampler_kinds.size(); ++kind)
    plot.series.push_back(series_of(all, kind, seconds, &Noise::rmse_bound));
  std::vector<Tradeoff> tradeoffs;
  for (std::size_t i = 0; i < all.noise.size(); ++i)
    tradeoffs.push_back({seconds(all.noise[i]), all.noise[i].rmse_bound, i});
  plot.front = labelled_front(tradeoffs, [&all](std::size_t i) {
    return text("%s %d", name_of(all.noise[i].kind), all.noise[i].samples);
  });
  return plot;
}

std::vector<Tradeoff> front_of_filters(const Fronts& fronts) {
  return pareto_front(tradeoffs_of(fronts));
}

std::vector<Tradeoff> front_of_sky(const Fronts& fronts, const std::string& sky) {
  return pareto_front(tradeoffs_of(fronts, sky));
}

std::vector<std::string> skies_of(const Fronts& fronts) {
  std::vector<std::string> names;
  for (const SkyCost& each : fronts.skies) {
    if (std::find(names.begin(), names.end(), each.sky) == names.end()) names.push_back(each.sky);
  }
  return names;
}

Plot plot_filter_error(const Fronts& fronts) {
  Plot plot{.title = "Filters: time against error, checkers to the horizon, one ray a pixel",
            .x_title = "time of a look-up in ns, double, one thread",
            .y_title = "root mean square error of light, 255 is white"};
  for (const FilterCost& filter : fronts.filters) {
    const std::string family = filter.name.substr(0, filter.name.find(' '));
    if (plot.series.empty() || plot.series.back().name != family)
      plot.series.push_back({family, static_cast<int>(plot.series.size())});
    plot.series.back().points.push_back({filter.nanoseconds, filter.levels(), {}});
  }
  plot.front = labelled_front(tradeoffs_of(fronts),
                              [&fronts](std::size_t i) { return fronts.filters[i].name; });
  return plot;
}

Plot plot_sky_error(const Fronts& fronts) {
  Plot plot{.title = "Skies: time against error; a line joins what no other under its sky beats",
            .x_title = "microseconds a pixel, packs of double, one thread",
            .y_title = "root mean square error, levels of 255"};
  std::size_t at = 0;
  for (const std::string& sky : skies_of(fronts)) {
    const std::vector<Tradeoff> all = tradeoffs_of(fronts, sky);
    PlotSeries tried{sky + " sky", sky_styles[at++ % sky_styles.size()]};
    for (const Tradeoff& each : all) tried.points.push_back({each.time, each.error, {}});
    PlotSeries front{"", tried.style, {}, true};
    front.points = labelled_front(all, [&fronts](std::size_t i) {
      return fronts.skies[i].way + text(" %d", fronts.skies[i].samples);
    });
    plot.series.insert(plot.series.end(), {tried, front});
  }
  return plot;
}

}  // namespace texmap::chapter_13
