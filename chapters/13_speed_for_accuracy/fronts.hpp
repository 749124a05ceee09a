// The three plots of this chapter: speed against error, error against samples, error against seconds.
#pragma once
#include "front.hpp"
#include "plot.hpp"
#include "table.hpp"

namespace texmap::chapter_13 {

/// Every number and kernel with the nearest texel: its time, and how far off a place can be at most.
[[nodiscard]] inline Plot plot_speed_error(const Measurements& all) {
  Plot plot{"Speed against error: places on the texture, one ray a pixel",
            "time, plain double with the reference formula = 1",
            "a place is off by at most, in texels",
            {},
            {}};
  std::vector<Tradeoff> tradeoffs;
  for (std::size_t i = 0; i < all.places.size(); ++i) {
    const Trial& trial = all.places[i];
    if (trial.way.filter != Filter::nearest) continue;
    tradeoffs.push_back({trial.time, trial.errors.texels_bound, i});
    const std::string name =
        name_of(trial.way.number) + (is_pack(trial.way.number) ? std::string(", ") + name_of(trial.way.instructions) : "");
    const auto is_named = [&name](const PlotSeries& each) { return each.name == name; };
    if (std::none_of(plot.series.begin(), plot.series.end(), is_named)) {
      plot.series.push_back({name, static_cast<int>(plot.series.size()) % 9, {}});
    }
    PlotSeries& series = *std::find_if(plot.series.begin(), plot.series.end(), is_named);
    series.points.push_back({trial.time, trial.errors.texels_bound, {}});
    if (!is_pack(trial.way.number) && trial.way.degree == 0) series.points.back().label = name + ", reference";
  }
  for (const Tradeoff& best : front_of(tradeoffs)) {
    const Trial& trial = all.places[best.index];
    plot.front.push_back({best.time, best.error, name_of_kernel(trial.way.degree)});
  }
  return plot;
}

/// The noise of each sampler, against its samples or against its time.
[[nodiscard]] inline Plot plot_noise(const Measurements& all, bool against_time) {
  Plot plot{against_time ? "Error against seconds" : "Error against samples",
            against_time
                ? "seconds for a picture of " + std::to_string(noise_width) + " x " + std::to_string(noise_height) +
                      " pixels, " + name_of(all.exact.number) +
                      (is_pack(all.exact.number) ? std::string(" of ") + name_of(all.exact.instructions) : "") + ", one thread"
                : "samples a pixel",
            "root mean square error, levels of 255",
            {},
            {}};
  std::vector<Tradeoff> tradeoffs;
  const std::array<int, 4> styles = {0, 4, 8, 1};
  for (std::size_t k = 0; k < sampler_kinds.size(); ++k) {
    PlotSeries mean{name_of(sampler_kinds[k]), styles[k], {}, true};
    PlotSeries most{mean.name + ", at most", styles[k], {}, true, true};
    for (std::size_t i = 0; i < all.noise.size(); ++i) {
      const Noise& noise = all.noise[i];
      if (noise.kind != sampler_kinds[k]) continue;
      const double x = against_time ? noise.milliseconds / 1000 : noise.samples;
      mean.points.push_back({x, noise.rmse, {}});
      most.points.push_back({x, noise.rmse_bound, {}});
      tradeoffs.push_back({x, noise.rmse_bound, i});
    }
    if (!against_time) mean.points.back().label = printed("%.2f", mean.points.back().y);
    plot.series.push_back(mean);
    plot.series.push_back(most);
  }
  if (!against_time) return plot;
  for (const Tradeoff& best : front_of(tradeoffs)) {
    const Noise& noise = all.noise[best.index];
    plot.front.push_back({best.time, best.error, printed("%s %d", name_of(noise.kind), noise.samples)});
  }
  return plot;
}

}  // namespace texmap::chapter_13
