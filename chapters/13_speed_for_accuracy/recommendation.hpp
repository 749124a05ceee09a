// The recommendation: for a budget, the fastest way whose stated bound keeps to it, and the command that uses it.
#pragma once
#include "front.hpp"
#include "table.hpp"

namespace texmap::chapter_13 {

/// True if a way keeps to a budget by its bounds, whatever was measured.
///
/// `exact` is what plain double draws with the reference formula; others draw the same if no rounding can change a byte of it.
/// Texels are those of texels_bound; levels are the most that any pixel can change, outline and edges of texels included.
[[nodiscard]] inline bool keeps_to(const Budget& budget, const Trial& trial) {
  switch (budget.unit) {
    case Budget::Unit::texels:
      return trial.errors.texels_bound <= budget.limit;
    case Budget::Unit::levels:
      return trial.errors.levels_bound <= budget.limit;
    case Budget::Unit::exact:
      break;
  }
  return trial.way.degree == 0 && (trial.way.number == Number::double_ || trial.errors.may_change == 0);
}

/// Of the trials that may be taken the fastest; of those that are as fast, the one with the least of an error. nullptr if none
/// may be.
template <class MayBe>
[[nodiscard]] const Trial* fastest_of(const std::vector<Trial>& trials, double Errors::*error, const MayBe& may_be) {
  auto shortest = infinity<double>();
  for (const Trial& trial : trials) {
    if (may_be(trial)) shortest = std::min(shortest, trial.milliseconds);
  }
  const Trial* best = nullptr;
  for (const Trial& trial : trials) {
    if (!may_be(trial) || trial.milliseconds > same_time * shortest) continue;
    if (best == nullptr || trial.errors.*error < best->errors.*error) best = &trial;
  }
  return best;
}

/// Of the places with a filter that keep to the budget the fastest, and then the most exact.
[[nodiscard]] inline const Trial* fastest(const std::vector<Trial>& places, Filter filter, const Budget& budget) {
  return fastest_of(places, &Errors::texels_bound,
                    [&](const Trial& trial) { return trial.way.filter == filter && keeps_to(budget, trial); });
}

/// Of the ways from texels to bytes that keep to a budget in levels the fastest, and then the most exact: of numbers that find
/// every texel, since a wrong one may be any number of levels off.
[[nodiscard]] inline const Trial* fastest_light(const Measurements& all, const Budget& budget) {
  return fastest_of(all.curves, &Errors::unrounded_bound, [&](const Trial& trial) {
    const Trial* place = find_trial(all.places, {.number = trial.way.number, .instructions = trial.way.instructions});
    return keeps_to(budget, trial) && place != nullptr && keeps_to({}, *place);
  });
}

/// The fastest sampler whose noise keeps to a number of levels, root mean square; nullptr if none does.
[[nodiscard]] inline const Noise* fastest(const std::vector<Noise>& all, double levels) {
  const Noise* best = nullptr;
  for (const Noise& noise : all) {
    if (noise.rmse_bound > levels) continue;
    if (best == nullptr || noise.milliseconds < best->milliseconds) best = &noise;
  }
  return best;
}

/// The shortest budget in texels for which choose_uv_kernel takes the kernel of this degree; `exact` for the reference formula.
[[nodiscard]] inline std::string budget_for(int degree, const Image& texture) {
  if (degree == 0) return "exact";
  const UvError kernel = degree < 23 ? kernel_bound<float>(degree) : kernel_bound<double>(degree);
  const double worst = std::max(kernel.u * texture.width, kernel.v * texture.height);
  std::string text;
  for (int digits = 1; digits <= 17; ++digits) {
    const double unit = std::pow(10.0, std::floor(std::log10(worst)) + 1 - digits);
    text = printed("texels=%.*g", digits, std::ceil(worst / unit) * unit);
    if (choose_uv_kernel(parse_budget(text), texture.width, texture.height, Directions::unit).degree == degree) break;
  }
  return text;
}

/// The command that draws chapter 07 with a way's number and for a budget, as text.
[[nodiscard]] inline std::string command_of(const Way& way, const std::string& budget) {
  std::string command = std::string("./course run 07 --number ") + name_of(way.number);
  if (is_pack(way.number) && way.instructions != usable_instructions(Instructions::avx512).back()) {
    command += std::string(" --instructions ") + name_of(way.instructions);
  }
  return command + (budget == "exact" ? "" : " --budget " + budget);
}

/// What to take from texels to bytes, for a budget in levels.
[[nodiscard]] inline std::string recommendation_of_light(const Measurements& all, const Budget& budget) {
  const Trial* trial = fastest_light(all, budget);
  if (trial == nullptr) return "  light     nothing that was tried keeps to it\n";
  const Errors& errors = trial->errors;
  return printed("  light     %s, texels as %s: %.1f times faster than plain double\n", described_number(trial->way).c_str(),
                 described_light(trial->way).c_str(), 1 / trial->time) +
         printed("            at most %.2f levels off, not rounded; pixels that may change: %ld, levels: %d\n",
                 errors.unrounded_bound, errors.may_change, errors.levels_bound) +
         "            " + command_of(trial->way, to_text(budget)) + "\n";
}

/// What to take for a budget, in a few lines of at most 110 columns.
[[nodiscard]] inline std::string recommendation(const Measurements& all, const Budget& budget, const Image& texture) {
  std::string text = "For " + to_text(budget) + ":\n";
  for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
    const Trial* trial = fastest(all.places, filter, budget);
    text += printed("  %-9s ", name_of(filter));
    if (trial == nullptr) {
      text += "nothing that was tried keeps to it\n";
      continue;
    }
    const Trial* plain = find_trial(all.places, {.filter = filter});
    text += printed(
        "%s: %.1f times faster than plain double\n            at most %.1e texels off; pixels that may change: %ld, levels: "
        "%d\n",
        described(trial->way).c_str(), plain->milliseconds / trial->milliseconds, trial->errors.texels_bound,
        trial->errors.may_change, trial->errors.levels_bound);
    if (filter == Filter::nearest)
      text += "            " + command_of(trial->way, budget_for(trial->way.degree, texture)) + "\n";
  }
  if (budget.unit != Budget::Unit::levels) return text;
  text += recommendation_of_light(all, budget);
  const Noise* noise = fastest(all.noise, budget.limit);
  if (noise == nullptr) return text + "  samples   more than were tried\n";
  return text + printed(
                    "  samples   %s, %d a pixel: noise of at most %.2f levels, root mean square\n            "
                    "./course run 07 --sampler %s --samples %d\n",
                    name_of(noise->kind), noise->samples, noise->rmse_bound, name_of(noise->kind), noise->samples);
}

/// The same for several budgets.
[[nodiscard]] inline std::string recommendations(const Measurements& all, const std::vector<Budget>& budgets,
                                                 const Image& texture) {
  std::string text;
  for (const Budget& each : budgets) text += recommendation(all, each, texture);
  return text;
}

}  // namespace texmap::chapter_13
