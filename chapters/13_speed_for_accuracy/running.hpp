// What running this chapter takes: its options checked, its work counted.
#pragma once
#include "noise.hpp"
#include "studio.hpp"

namespace texmap::chapter_13 {

/// The budgets that every run recommends for, and the user's.
/// Errors: UsageError.
[[nodiscard]] inline std::vector<Budget> budgets_with(const std::string& typed) {
  std::vector<Budget> budgets = {parse_budget("exact"), parse_budget("texels=0.01"), parse_budget("levels=1")};
  try {
    if (!typed.empty()) budgets.push_back(parse_budget(typed));
  } catch (const std::invalid_argument& error) {
    throw UsageError("--budget: " + std::string(error.what()));
  }
  return budgets;
}

/// Errors: UsageError for options that choose one of what this chapter tries all of.
inline void refuse_what_is_varied(const Studio& studio) {
  for (const char* option : {"--number", "--samples"}) {
    if (studio.typed(option))
      throw UsageError(std::string(option) + ": this chapter tries all of them; --rounds says how often");
  }
}

/// How many rounds the samplers are timed: they take longer, and their ratios are larger.
[[nodiscard]] inline int noise_rounds(int rounds) { return rounds / 4 + 1; }

/// How often a whole run ticks.
[[nodiscard]] inline int parts_of(int rounds, Instructions widest) {
  const int trials = static_cast<int>(all_places(widest).size() + all_curves(widest).size());
  const int samplers = static_cast<int>(sampler_kinds.size() * sample_counts.size());
  const int panels = 16;
  return trials * (rounds + 2) + noise_views + samplers * (noise_rounds(rounds) + 2) + panels;
}

/// How many rays a whole run follows, but for those of the sheet.
[[nodiscard]] inline double rays_of(const View& view, int rounds, Instructions widest) {
  const double trials = static_cast<double>(all_places(widest).size() + all_curves(widest).size());
  double samples = 0;
  for (const int count : sample_counts) samples += static_cast<double>(sampler_kinds.size()) * count;
  const double pixels = static_cast<double>(view.width) * view.height;
  return pixels * trials * (rounds + 2) +
         noise_width * noise_height *
             (samples * (noise_views + noise_rounds(rounds) + 1) + 1.0 * noise_views * converged_samples);
}

/// Counts the parts of a run that are done.
class Ticks {
 public:
  Ticks(const RenderSettings& settings, int total) : settings_(settings), total_(total) {}
  void operator()() {
    if (settings_.progress) settings_.progress(std::min(++done_, total_), total_);
  }

 private:
  const RenderSettings& settings_;
  int total_;
  int done_ = 0;
};

}  // namespace texmap::chapter_13
