// The six plots of this chapter, and the front of what nothing else beats.
#pragma once
#include <functional>

#include "engine/measure/plot.hpp"
#include "table.hpp"

namespace texmap::chapter_13 {

/// A time and an error, and which of many it belongs to.
struct Tradeoff {
  double time, error;
  std::size_t index;
};

/// The Pareto front, from the fastest to the most exact: whatever is faster than one of them is
/// farther off.
///
/// Of several with the same time it has the most exact, of several with the same error the fastest.
[[nodiscard]] std::vector<Tradeoff> pareto_front(std::vector<Tradeoff> all);

/// The front as a plot shows it: of neighbours that are as fast only the most exact has a label.
///
/// @param label  called with an index, gives what is written there
[[nodiscard]] std::vector<PlotPoint> labelled_front(
    const std::vector<Tradeoff>& tradeoffs, const std::function<std::string(std::size_t)>& label);

/// The trade: every number with some kernels and the nearest texel, its time with its spread, and
/// how far off a place can be at most.
[[nodiscard]] Plot plot_speed_error(const Measurements& all);
/// Every curve and both texel formats: the time, and how far off a channel can be at most, of which
/// the rounding to bytes is half a level.
[[nodiscard]] Plot plot_speed_levels(const Measurements& all);
/// The noise of each sampler against its samples.
[[nodiscard]] Plot plot_error_samples(const Measurements& all);
/// The noise that each sampler does not exceed against the time that it takes.
[[nodiscard]] Plot plot_error_seconds(const Measurements& all);
/// Every filter: the time of a look-up, and how many levels of light it is off.
[[nodiscard]] Plot plot_filter_error(const Fronts& fronts);
/// Every way with all its samples: the time of a pixel and its error, and the front of each sky.
[[nodiscard]] Plot plot_sky_error(const Fronts& fronts);

/// The figures of one sky that no other of that sky beats in both time and error, from the fastest.
[[nodiscard]] std::vector<Tradeoff> front_of_sky(const Fronts& fronts, const std::string& sky);
/// The same of the filters.
[[nodiscard]] std::vector<Tradeoff> front_of_filters(const Fronts& fronts);
/// The skies' names, in their order.
[[nodiscard]] std::vector<std::string> skies_of(const Fronts& fronts);

}  // namespace texmap::chapter_13
