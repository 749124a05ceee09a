// What running this chapter takes: its options checked, its work counted.
#pragma once
#include "studio.hpp"
#include "table.hpp"

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

/// A part of a run that the progress line names.
struct Stage {
  const char* name;
  int parts;  ///< ticks
};

/// All of a run, in their order.
[[nodiscard]] inline std::vector<Stage> stages_of(int rounds, Instructions widest) {
  const int places = static_cast<int>(all_places(widest).size());
  const int curves = static_cast<int>(all_curves(widest).size());
  const int samplers = static_cast<int>(sampler_kinds.size() * sample_counts.size());
  const int kept = static_cast<int>(all_kept(widest).size());
  return {{"errors of places", places},
          {"errors of curves", curves},
          {"times of places", places * (rounds + 1)},
          {"times of curves", curves * (rounds + 1)},
          {"texels with many rays", kept * (noise_rounds(rounds) + 2)},
          {"errors of samplers", noise_views + samplers},
          {"times of samplers", samplers * (noise_rounds(rounds) + 1)},
          {"sheet", 16}};
}

/// How many rays a whole run follows, but for those of the sheet.
[[nodiscard]] inline double rays_of(const Measurements& all) {
  double samples = 0;
  for (const int count : sample_counts) samples += static_cast<double>(sampler_kinds.size()) * count;
  const auto runs = [&all](std::size_t timing) { return all.rounds[timing].timed + 2.0; };  // judged and run before, too
  const double pixels = static_cast<double>(all.width) * all.height;
  return pixels * (static_cast<double>(all.places.size()) * runs(0) + static_cast<double>(all.curves.size()) * runs(1)) +
         noise_width * noise_height *
             (static_cast<double>(all.kept.size()) * kept_samples * (runs(2) + 1) + samples * (noise_views - 1 + runs(3)) +
              1.0 * noise_views * converged_samples);
}

/// Counts the parts of a run that are done, for its progress line.
class Ticks {
 public:
  explicit Ticks(std::vector<Stage> stages) : stages_(std::move(stages)) {
    for (const Stage& stage : stages_) total_ += stage.parts;
  }
  void operator()(const RenderSettings& settings) {
    if (settings.progress) settings.progress(std::min(++done_, total_), total_);
  }

  /// What the line says at its end: the stage of the next part, none if all are done.
  [[nodiscard]] std::string remark() const {
    int before = 0;
    for (const Stage& stage : stages_) {
      before += stage.parts;
      if (done_ < before) return std::string(", ") + stage.name;
    }
    return "";
  }

 private:
  std::vector<Stage> stages_;
  int total_ = 0;
  int done_ = 0;
};

}  // namespace texmap::chapter_13
