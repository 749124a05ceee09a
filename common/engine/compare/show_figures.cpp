// The figures of a comparison for readers and for other programs.
#include "engine/compare/show_figures.hpp"

#include <cmath>

#include "engine/measure/text.hpp"

namespace texmap {
namespace {

std::string text_of(Rgb8 color) { return text("(%d, %d, %d)", color.r, color.g, color.b); }

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

std::string differing_pixels(const Figures& f) {
  const std::size_t off = pixels_off_by_more_than(f, 1);
  const double percent = 100 * static_cast<double>(off) / static_cast<double>(f.pixels_compared);
  return text("%zu of %zu pixels by more than one level (%.2g %%), %zu by one", off,
              f.pixels_compared, percent, f.pixels_different - off);
}

std::vector<std::vector<std::string>> figure_rows(const Figures& f) {
  std::vector<std::vector<std::string>> rows;
  const auto row = [&rows](const char* name, const std::string& value) {
    rows.push_back({name, value});
  };
  row("size", text("%d x %d pixels, %zu compared", f.width, f.height, f.pixels_compared));
  row("different", differing_pixels(f));
  if (f.pixels_different > 0) {
    row("within", text("columns %d to %d, rows %d to %d", f.box.left, f.box.left + f.box.width - 1,
                       f.box.top, f.box.top + f.box.height - 1));
    row("largest difference",
        text("%d levels at column %d, row %d: %s and %s", f.worst.levels, f.worst.column,
             f.worst.row, text_of(f.worst.a).c_str(), text_of(f.worst.b).c_str()));
  }
  row("mean absolute error", text("%g levels", f.mean_absolute_error));
  row("RMSE", text("%g levels", f.root_mean_square_error));
  const double psnr = f.peak_signal_to_noise;
  row("PSNR", std::isinf(psnr) ? "infinite dB" : text("%g dB", psnr));
  if (!std::isnan(f.structural_similarity))
    row("SSIM", text("%.10g (1: equal)", f.structural_similarity));
  row("mean value", text("%g and %g levels", f.mean_a, f.mean_b));
  return rows;
}

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

}  // namespace texmap
