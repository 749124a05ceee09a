// The recommendation: for a budget, the fastest variant whose stated bound keeps to it, and the
// command that uses it.
#include "recommendation.hpp"

#include <algorithm>
#include <cmath>

#include "engine/measure/text.hpp"

namespace texmap::chapter_13 {
namespace {

/// Of the trials that may be taken the fastest; of those that are as fast, the one with the least
/// of an error.
template <class MayBe>
const Trial* fastest_of(const std::vector<Trial>& trials, double Errors::*error,
                        const MayBe& may_be) {
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
      "  %-9s %s: %.1f times faster than plain double\n            at most %.1e texels off; "
      "pixels that may change: %ld, levels: %d\n",
      name_of(filter), described(trial->variant).c_str(), plain->milliseconds / trial->milliseconds,
      trial->errors.texels_bound, trial->errors.may_change, trial->errors.levels_bound);
  if (filter == Filter::nearest) {
    lines += "            " +
             command_of(trial->variant, budget_for(trial->variant.degree, texture)) + "\n";
  }
  return lines;
}

std::string recommended_light(const Measurements& all, const Budget& budget) {
  const Trial* trial = fastest_light(all, budget);
  if (trial == nullptr) return "  light     nothing that was tried keeps to it\n";
  return text(
      "  light     %s, texels as %s: %.1f times faster than plain double\n            at most %.2f "
      "levels off, not rounded; pixels that may change: %ld, levels: %d\n            %s\n",
      described_number(trial->variant).c_str(), described_light(trial->variant).c_str(),
      1 / trial->time, trial->errors.unrounded_bound, trial->errors.may_change,
      trial->errors.levels_bound, command_of(trial->variant, to_text(budget)).c_str());
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

}  // namespace

bool keeps_to(const Budget& budget, const Trial& trial) {
  if (budget.unit == Budget::Unit::texels) return trial.errors.texels_bound <= budget.limit;
  if (budget.unit == Budget::Unit::levels) return trial.errors.levels_bound <= budget.limit;
  return trial.variant.degree == 0 &&
         (trial.variant.number == NumberKind::double_ || trial.errors.may_change == 0);
}

const Trial* fastest(const std::vector<Trial>& places, Filter filter, const Budget& budget) {
  return fastest_of(places, &Errors::texels_bound, [&](const Trial& trial) {
    return trial.variant.filter == filter && keeps_to(budget, trial);
  });
}

const Trial* fastest_light(const Measurements& all, const Budget& budget) {
  return fastest_of(all.curves, &Errors::unrounded_bound, [&](const Trial& trial) {
    const Trial* place = find_trial(
        all.places, {.number = trial.variant.number, .instructions = trial.variant.instructions});
    return keeps_to(budget, trial) && place != nullptr && keeps_to({}, *place);
  });
}

const Noise* fastest(const std::vector<Noise>& all, double levels) {
  const Noise* best = nullptr;
  for (const Noise& noise : all) {
    if (noise.rmse_bound > levels) continue;
    if (best == nullptr || noise.milliseconds < best->milliseconds) best = &noise;
  }
  return best;
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
  return lines + recommended_light(all, budget) + recommended_samples(all, budget.limit);
}

}  // namespace texmap::chapter_13
