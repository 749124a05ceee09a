// The recommendation: for a budget, the fastest variant with a stated bound within it, and the
// command that uses it.
#include "recommendation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/measure/text.hpp"
#include "plots.hpp"

namespace texmap::chapter_13 {
namespace {

WorkTime time_of(const Trial& trial) { return trial.took; }
WorkTime time_of(const Noise& noise) { return noise.took; }
WorkTime time_of(const FilterCost& filter) {
  return {filter.nanoseconds, filter.nanoseconds, filter.spread};
}
WorkTime time_of(const SkyCost& cost) {
  return {cost.microseconds, cost.microseconds, cost.spread};
}

/// Of the items that may be taken the fastest; of those that could be as fast, as far as the spread
/// of the times tells, the one with the least error.
///
/// @param error, may_be  of an item: called with one, or its member
template <class Item, class Error, class MayBe>
const Item* fastest_of(const std::vector<Item>& items, const Error& error, const MayBe& may_be) {
  WorkTime shortest;
  for (const Item& item : items) {
    if (may_be(item) && time_of(item).processor < shortest.processor) shortest = time_of(item);
  }
  const Item* best = nullptr;
  for (const Item& item : items) {
    const WorkTime time = time_of(item);
    const double same = std::max({same_time, time.spread, shortest.spread});
    if (!may_be(item) || time.processor > same * shortest.processor) continue;
    if (best == nullptr || std::invoke(error, item) < std::invoke(error, *best)) best = &item;
  }
  return best;
}

/// How many times as fast: "4.7", or "3.9 to 5.2" where the times spread as on a busy machine.
std::string times_as_fast(const WorkTime& plain, const WorkTime& time) {
  const double ratio = plain.processor / time.processor;
  if (std::max(plain.spread, time.spread) <= quiet_spread) return text("%.1f", ratio);
  return text("%.1f to %.1f", ratio / time.spread, ratio * plain.spread);
}

/// The command that draws chapter 07 with a variant's number and for a budget.
std::string command_of(const Variant& variant, const std::string& budget) {
  std::string command = std::string("./course run 07 --number ") + name_of(variant.number);
  if (is_pack(variant.number) &&
      variant.instructions != usable_instructions(Instructions::avx512).back())
    command += std::string(" --instructions ") + name_of(variant.instructions);
  return command + (budget == "exact" ? "" : " --budget " + budget);
}

std::string recommended_place(const Measurements& all, Filter filter, const Budget& budget,
                              const Image& texture) {
  const Trial* trial = fastest(all.places, filter, budget);
  if (trial == nullptr) return text("  %-9s nothing that was tried keeps to it\n", name_of(filter));
  const Trial* plain = find_trial(all.places, {.filter = filter});
  std::string lines = text(
      "  %-9s %s: %s times as fast as plain double with this filter\n            at most %.1e "
      "texels off; "
      "pixels that may change: %ld, levels: %d\n",
      name_of(filter), described(trial->variant).c_str(),
      times_as_fast(plain->took, trial->took).c_str(), trial->errors.texels_bound,
      trial->errors.may_change, trial->errors.levels_bound);
  if (filter != Filter::nearest) return lines;
  const int degree = trial->variant.degree;
  lines += "            " + command_of(trial->variant, budget_for(degree, texture)) + "\n";
  if (degree > 0) {
    lines +=
        "            (chapter 07's --budget is the polynomial's share alone; rounding adds the "
        "rest of the bound)\n";
  }
  return lines;
}

std::string recommended_light(const Measurements& all, const Budget& budget) {
  const Trial* trial = fastest_light(all, budget);
  if (trial == nullptr) return "  light     nothing that was tried keeps to it\n";
  return text(
      "  light     %s, texels as %s: %s times as fast as plain double\n            at most %.2f "
      "levels off, not rounded; pixels that may change: %ld, levels: %d\n            %s\n"
      "            (float is left out where its places may take the neighboring texel)\n",
      described_number(trial->variant).c_str(), described_light(trial->variant).c_str(),
      times_as_fast(all.curves.front().took, trial->took).c_str(), trial->errors.unrounded_bound,
      trial->errors.may_change, trial->errors.levels_bound,
      command_of(trial->variant, to_text(budget)).c_str());
}

std::string recommended_samples(const Measurements& all, double levels) {
  const Noise* noise = fastest(all.noise, levels);
  if (noise == nullptr) return "  samples   more than were tried\n";
  const char* kind = name_of(noise->kind);
  return text(
      "  samples   %s, %d a pixel: noise of at most %.2f levels, root mean square\n            "
      "./course run 07 --sampler %s --samples %d\n",
      kind, noise->samples, noise->rmse_bound, kind, noise->samples);
}

std::string recommended_filter(const Fronts& fronts, double levels) {
  const FilterCost* filter = cheapest(fronts.filters, levels);
  if (filter == nullptr) return "  filter    nothing that was tried keeps to it\n";
  return text(
      "  filter    %s: %.2f levels of light off on checkers to the horizon, root mean square\n"
      "            ./course run 09 %s\n",
      filter->name.c_str(), filter->levels(), filter->options.c_str());
}

std::string recommended_skies(const Fronts& fronts, double levels) {
  std::string lines;
  for (const std::string& sky : skies_of(fronts)) {
    const SkyCost* cost = cheapest(fronts.skies, sky, levels);
    const std::string start = text("  %-9s ", lines.empty() ? "sky" : "") + sky + ": ";
    if (cost == nullptr) {
      lines += start + "nothing that was tried keeps to it\n";
      continue;
    }
    // The sun is in chapter 12's own sky; for another one the user has a picture.
    lines += start + text(
                         "%s, %d samples per pixel: %.2f levels off, root mean square\n"
                         "            ./course run 12%s --light %s --samples %d\n",
                         cost->way.c_str(), cost->samples, cost->error,
                         sky == "sun" ? "" : " --sky FILE", cost->way.c_str(), cost->samples);
  }
  return lines;
}

}  // namespace

bool keeps_to(const Budget& budget, const Trial& trial) {
  if (budget.unit == Budget::Unit::texels) return trial.errors.texels_bound <= budget.limit;
  if (budget.unit == Budget::Unit::levels) return trial.errors.levels_bound <= budget.limit;
  return trial.variant.degree == 0 &&
         (trial.variant.number == NumberKind::double_ || trial.errors.may_change == 0);
}

const Trial* fastest(const std::vector<Trial>& places, Filter filter, const Budget& budget) {
  return fastest_of(
      places, [](const Trial& trial) { return trial.errors.texels_bound; },
      [&](const Trial& trial) {
        return trial.variant.filter == filter && keeps_to(budget, trial);
      });
}

const Trial* fastest_light(const Measurements& all, const Budget& budget) {
  return fastest_of(
      all.curves, [](const Trial& trial) { return trial.errors.unrounded_bound; },
      [&](const Trial& trial) {
        const Trial* place = find_trial(all.places, {.number = trial.variant.number,
                                                     .instructions = trial.variant.instructions});
        return keeps_to(budget, trial) && place != nullptr && keeps_to({}, *place);
      });
}

const Noise* fastest(const std::vector<Noise>& all, double levels) {
  return fastest_of(all, &Noise::rmse_bound,
                    [levels](const Noise& noise) { return noise.rmse_bound <= levels; });
}

const FilterCost* cheapest(const std::vector<FilterCost>& all, double levels) {
  return fastest_of(all, &FilterCost::error,
                    [levels](const FilterCost& filter) { return filter.levels() <= levels; });
}

const SkyCost* cheapest(const std::vector<SkyCost>& all, const std::string& sky, double levels) {
  return fastest_of(all, &SkyCost::error,
                    [&](const SkyCost& cost) { return cost.sky == sky && cost.error <= levels; });
}

std::string budget_for(int degree, const Image& texture) {
  if (degree == 0) return "exact";
  const UvError kernel =
      kernel_bound(degree < 23 ? NumberKind::float_ : NumberKind::double_, degree);
  const double worst = std::max(kernel.u * texture.width, kernel.v * texture.height);
  std::string budget;
  for (int digits = 1; digits <= 17; ++digits) {
    const double unit = std::pow(10.0, std::floor(std::log10(worst)) + 1 - digits);
    budget = text("texels=%.*g", digits, std::ceil(worst / unit) * unit);
    if (choose_uv_kernel(parse_budget(budget), texture.width, texture.height).degree == degree)
      break;
  }
  return budget;
}

std::string recommendation(const Measurements& all, const Budget& budget, const Image& texture) {
  std::string lines = "For " + to_text(budget) + ":\n";
  for (const Filter filter : {Filter::nearest, Filter::bilinear})
    lines += recommended_place(all, filter, budget, texture);
  if (budget.unit != Budget::Unit::levels) return lines;
  return lines + recommended_light(all, budget) + recommended_samples(all, budget.limit) +
         recommended_filter(all.fronts, budget.limit) + recommended_skies(all.fronts, budget.limit);
}

}  // namespace texmap::chapter_13
