// The figures of a comparison for other programs.
#include "engine/compare/figures_json.hpp"

#include <cmath>

namespace texmap {
namespace {

Json json_of(Rgb8 color) { return Json::list({color.r, color.g, color.b}); }

Json json_of(const Box& box) {
  return Json::object(
      {{"left", box.left}, {"top", box.top}, {"width", box.width}, {"height", box.height}});
}

Json json_of(const WorstPixel& worst) {
  return Json::object({{"levels", worst.levels},
                       {"column", worst.column},
                       {"row", worst.row},
                       {"a", json_of(worst.a)},
                       {"b", json_of(worst.b)}});
}

}  // namespace

Json json_of(const Figures& figures) {
  const bool differ = figures.pixels_different > 0;
  const bool finite = std::isfinite(figures.peak_signal_to_noise);
  return Json::object(
      {
          {"width", figures.width},
          {"height", figures.height},
          {"pixels_compared", figures.pixels_compared},
          {"pixels_different", figures.pixels_different},
          {"share_different", figures.share_different},
          {"box", differ ? json_of(figures.box) : nullptr},
          {"largest_difference", differ ? json_of(figures.worst) : nullptr},
          {"mean_absolute_error", figures.mean_absolute_error},
          {"root_mean_square_error", figures.root_mean_square_error},
          {"psnr", finite ? "finite" : "infinite"},
          {"psnr_db", figures.peak_signal_to_noise},
          {"ssim", figures.structural_similarity},
          {"mean_a", figures.mean_a},
          {"mean_b", figures.mean_b},
      },
      true);
}

std::string figures_json(const Figures& figures) { return json_of(figures).text + "\n"; }

}  // namespace texmap
