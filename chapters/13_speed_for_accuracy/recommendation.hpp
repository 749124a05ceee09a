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

/// Of the trials with a filter that keep to the budget the fastest; of those that are as fast, the most exact. nullptr if none
/// keeps to it.
[[nodiscard]] inline const Trial* fastest(const std::vector<Trial>& trials, Filter filter, const Budget& budget) {
  const auto may_do = [&](const Trial& trial) { return trial.way.filter == filter && keeps_to(budget, trial); };
  auto shortest = infinity<double>();
  for (const Trial& trial : trials) {
    if (may_do(trial)) shortest = std::min(shortest, trial.milliseconds);
  }
  const Trial* best = nullptr;
  for (const Trial& trial : trials) {
    if (!may_do(trial) || trial.milliseconds > same_time * shortest) continue;
    if (best == nullptr || trial.errors.texels_bound < best->errors.texels_bound) best = &trial;
  }
  return best;
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

/// The command that draws chapter 07 in this way.
[[nodiscard]] inline std::string command_of(const Way& way, const Image& texture) {
  std::string command = std::string("./course run 07 --number ") + name_of(way.number);
  if (is_pack(way.number) && way.instructions != usable_instructions(Instructions::avx512).back()) {
    command += std::string(" --instructions ") + name_of(way.instructions);
  }
  return command + (way.degree == 0 ? "" : " --budget " + budget_for(way.degree, texture));
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
    if (filter == Filter::nearest) text += "            " + command_of(trial->way, texture) + "\n";
  }
  if (budget.unit != Budget::Unit::levels) return text;
  const Noise* noise = fastest(all.noise, budget.limit);
  if (noise == nullptr) return text + "  samples   more than were tried\n";
  return text + printed(
                    "  samples   %s, %d a pixel: noise of at most %.2f levels, root mean square\n            "
                    "./course run 07 --sampler %s --samples %d\n",
                    name_of(noise->kind), noise->samples, noise->rmse_bound, name_of(noise->kind), noise->samples);
}

}  // namespace texmap::chapter_13
