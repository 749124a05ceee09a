// From an allowed error to the cheapest filter that keeps it in this scene.
#include "plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/files/text.hpp"
#include "engine/run/chosen.hpp"
#include "engine/run/command_line.hpp"

namespace texmap::chapter_09 {
namespace {

constexpr std::array candidates = {
    std::pair(Filter::bilinear, 1),    std::pair(Filter::trilinear, 1),
    std::pair(Filter::anisotropic, 2), std::pair(Filter::anisotropic, 4),
    std::pair(Filter::anisotropic, 8), std::pair(Filter::anisotropic, 16),
    std::pair(Filter::anisotropic, 64)};

std::string name_of(const FilterPlan& plan) {
  if (plan.filter == Filter::bilinear) return "bilinear";
  if (plan.filter == Filter::trilinear) return "trilinear";
  return text("anisotropic, at most %d reads along a footprint", plan.taps);
}

/// A ray with its derivatives by column and row, for samples at this distance.
Ray<Dual<double>> dual_ray(const View<>& view, double column, double row, double spacing) {
  return ray_through(view, Dual<double>{column, spacing, 0.0}, Dual<double>{row, 0.0, spacing});
}

/// Pixels that show a single object, and the longest side of a footprint there.
struct Probes {
  std::vector<PixelPlace<double>> places;
  double longest = 0;
};

Probes find_probes(const PlannedScene& scene, const View<>& view) {
  Probes probes;
  const int step = std::max(1, static_cast<int>(std::sqrt(view.width * view.height / 1000.0)));
  for (int row = step / 2; row < view.height; row += step) {
    for (int column = step / 2; column < view.width; column += step) {
      const int seen = scene.object_seen(ray_through<double>(view, column, row));
      bool one_object = seen > -2;
      for (const double x : {-0.5, 0.5}) {
        for (const double y : {-0.5, 0.5}) {
          const auto corner = ray_through<double>(view, column + x, row + y);
          one_object = one_object && scene.object_seen(corner) == seen;
        }
      }
      if (!one_object) continue;
      const double length = scene.footprint_length(seen, dual_ray(view, column, row, 1));
      probes.longest = std::max(probes.longest, length);
      probes.places.push_back({double(column), double(row)});
    }
  }
  return probes;
}

}  // namespace

FilterPlan plan_filter(const PlannedScene& scene, double levels, int width, int height) {
  const View<> view = view_of(scene.camera, width, height);
  const Probes probes = find_probes(scene, view);
  if (probes.longest <= 1) {
    return {Filter::bilinear, 1,
            text("bilinear: no pixel covers more than %.2f texels, so none needs a filter\n",
                 probes.longest)};
  }

  // The judge: 64 samples per pixel, each with an anisotropic footprint of an eighth of a pixel.
  const FilterPlan judge{Filter::anisotropic, 16, ""};
  std::vector<double> exact;
  for (const PixelPlace<double>& at : probes.places) {
    double sum = 0;
    for (int i = 0; i < 64; ++i) {
      const int across = i % 8, down = i / 8;
      sum += scene.light(judge, dual_ray(view, at.column + (across - 3.5) / 8,
                                         at.row + (down - 3.5) / 8, 1.0 / 8));
    }
    exact.push_back(sum / 64);
  }

  FilterPlan plan{};
  double error = 0;
  for (const auto& [filter, taps] : candidates) {
    plan.filter = filter;
    plan.taps = taps;
    double sum = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const PixelPlace<double>& at = probes.places[i];
      sum += square(scene.light(plan, dual_ray(view, at.column, at.row, 1)) - exact[i]);
    }
    error = 255 * std::sqrt(sum / static_cast<double>(exact.size()));
    if (error <= levels) break;
  }
  plan.text = text("%s: %.2f levels off on %zu pixels; the longest footprint is %.0f texels%s\n",
                   name_of(plan).c_str(), error, exact.size(), probes.longest,
                   error <= levels ? "" : "; no filter is within the budget");
  return plan;
}

std::optional<FilterPlan> plan_by_budget(const std::function<PlannedScene()>& scene,
                                         Chosen& chosen) {
  const Budget& budget = chosen.settings.budget;
  usage_error_if(chosen.was_given("--plot") && (chosen.was_given("--filter") || !budget.is_exact()),
                 "--plot compares all filters: leave out --filter and --budget");
  if (budget.is_exact()) return {};
  for (const char* option : {"--filter", "--taps"}) {
    usage_error_if(
        chosen.was_given(option),
        std::string("--budget chooses the filter: leave out ") + option + " or --budget");
  }
  if (budget.unit == Budget::Unit::texels) {
    throw UsageError("--budget: a filter's error is an amount of light: give exact or levels=N");
  }
  if (chosen.settings.zoom != 1)
    throw UsageError("--budget chooses a filter for the whole picture: leave --zoom out");
  chosen.default_size(800, 600);
  FilterPlan plan =
      plan_filter(scene(), budget.limit, chosen.settings.width, chosen.settings.height);
  chosen.say(plan.text);
  return plan;
}

}  // namespace texmap::chapter_09
