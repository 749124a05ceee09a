// How far a run is: its parts, counted.
#include "progress.hpp"

#include <algorithm>

namespace texmap::chapter_13 {

std::vector<Phase> phases_of(int rounds, Instructions widest) {
  const std::size_t places = all_places(widest).size();
  const std::size_t curves = all_curves(widest).size();
  const std::size_t formats = all_texel_formats(widest).size();
  const std::size_t samplers = sampler_kinds.size() * sample_counts.size();
  const auto runs = [](int timed) { return static_cast<std::size_t>(timed) + 1; };
  return {{"errors of places", places},
          {"errors of curves", curves},
          {"times of places", places * runs(rounds)},
          {"times of curves", curves * runs(rounds)},
          {"texels with many rays", formats * (runs(noise_rounds(rounds)) + 1)},
          {"errors of samplers", noise_views + samplers},
          {"times of samplers", samplers * runs(noise_rounds(rounds))},
          {"errors of filters", filter_error_ticks},
          {"times of filters", filters_timed * runs(rounds)},
          {"errors of skies", sky_error_ticks},
          {"times of skies", skies_timed * runs(noise_rounds(rounds))},
          {"sheet", 16}};
}

double rays_of(const Measurements& all) {
  double samples = 0;
  for (const int count : sample_counts)
    samples += static_cast<double>(sampler_kinds.size()) * count;
  const auto runs = [&all](std::size_t timing) {  // one for its errors and one before timing, too
    return all.rounds[timing].timed + 2.0;
  };
  const double pixels = static_cast<double>(all.width) * all.height;
  return all.fronts.rays +
         pixels * (static_cast<double>(all.places.size()) * runs(0) +
                   static_cast<double>(all.curves.size()) * runs(1)) +
         noise_width * noise_height *
             (static_cast<double>(all.texel_formats.size()) * texel_format_samples * (runs(2) + 1) +
              samples * (noise_views - 1 + runs(3)) + 1.0 * noise_views * converged_samples);
}

Ticks::Ticks(std::vector<Phase> stages) : phases_(std::move(stages)) {
  for (const Phase& stage : phases_) total_ += stage.parts;
}

void Ticks::operator()(const RenderSettings& settings) {
  done_ = std::min(done_ + 1, total_);
  if (settings.progress) settings.progress(static_cast<int>(done_), static_cast<int>(total_));
}

std::string Ticks::remark() const {
  std::size_t before = 0;
  for (const Phase& stage : phases_) {
    before += stage.parts;
    if (done_ < before) return std::string(", ") + stage.name;
  }
  return "";
}

}  // namespace texmap::chapter_13
