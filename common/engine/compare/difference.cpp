// The figures of two pictures: one pass over the pixels; then SSIM, by five blurred planes for each
// channel and one formula.
#include "engine/compare/difference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

#include "engine/draw/threads.hpp"
#include "engine/files/text.hpp"

namespace texmap {
namespace {

std::string size_of(const Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height);
}

constexpr double window_sigma = 1.5;  // pixels
constexpr int radius = 5;             // from the center of a window to its edge
constexpr double stabilizer_1 = (0.01 * 255) * (0.01 * 255);
constexpr double stabilizer_2 = (0.03 * 255) * (0.03 * 255);
constexpr int rows_of_a_band = 64;

constexpr std::size_t border = 2 * static_cast<std::size_t>(radius);  // without a whole window
using Window = std::array<double, 2 * radius + 1>;

/// A Gaussian, divided by its sum.
Window window_weights() {
  Window weights{};
  double sum = 0;
  for (int x = -radius; x <= radius; ++x) {
    double& weight = weights[static_cast<std::size_t>(x + radius)];
    weight = exp(-x * x / (2 * window_sigma * window_sigma));
    sum += weight;
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// Numbers in rows from the top, each row from the left.
struct Plane {
  std::size_t width, rows;
  std::vector<double> values = std::vector<double>(width * rows);

  [[nodiscard]] double* row(std::size_t y) { return values.data() + y * width; }
  [[nodiscard]] const double* row(std::size_t y) const { return values.data() + y * width; }
};

void add_scaled(double* sum, const double* row, double weight, std::size_t width) {
  for (std::size_t x = 0; x < width; ++x) sum[x] += weight * row[x];
}

/// Filters where the whole window lies inside: the result has two radii fewer columns and rows.
Plane blurred(const Plane& plane, const Window& window) {
  Plane across{plane.width - border, plane.rows};
  for (std::size_t y = 0; y < across.rows; ++y) {
    for (std::size_t i = 0; i < window.size(); ++i)
      add_scaled(across.row(y), plane.row(y) + i, window[i], across.width);
  }
  Plane both{across.width, plane.rows - border};
  for (std::size_t y = 0; y < both.rows; ++y) {
    for (std::size_t i = 0; i < window.size(); ++i)
      add_scaled(both.row(y), across.row(y + i), window[i], both.width);
  }
  return both;
}

/// The mean structural similarity (SSIM) of two pictures over all channels, -1 to 1. The same bits
/// with any number of threads.
///
/// @param a, b, mask  as for measure(), not checked; where the mask is black, `b` is taken for `a`
/// Source: Wang, Bovik, Sheikh, Simoncelli: Image Quality Assessment: From Error Visibility to
/// Structural Similarity, 2004, equation 13. Formula and edges: docs/numerics.md.
double mean_ssim(const Image& a, const Image& b, const Image& mask) {
  const Window window = window_weights();
  // The windows inside the picture count; all of them, if none of those is compared.
  int margin = radius;
  const auto counts = [&](int column, int row) {
    return column >= margin && column < a.width - margin && row >= margin &&
           row < a.height - margin && is_compared(mask, column, row);
  };
  const auto counted = [&] {
    std::size_t count = 0;
    for (int row = 0; row < a.height; ++row) {
      for (int column = 0; column < a.width; ++column) count += counts(column, row) ? 1U : 0U;
    }
    return count;
  };
  std::size_t count = counted();
  if (count == 0) {
    margin = 0;
    count = counted();
  }
  const auto width = static_cast<std::size_t>(a.width);
  std::vector<double> sums(static_cast<std::size_t>(a.height));
  for_each_row((a.height + rows_of_a_band - 1) / rows_of_a_band, 0, {}, [&](int band) {
    const int first = band * rows_of_a_band;
    const auto rows = static_cast<std::size_t>(std::min(rows_of_a_band, a.height - first));
    const std::size_t wide = width + border, high = rows + border;
    Plane similarity{width, rows};
    Plane of_a{wide, high}, of_b{wide, high}, of_aa{wide, high}, of_bb{wide, high},
        of_ab{wide, high};
    for (const auto channel : {&Rgb8::r, &Rgb8::g, &Rgb8::b}) {
      for (std::size_t y = 0; y < high; ++y) {
        // Outside the picture, the pixels at its edge repeat.
        const int row = std::clamp(first + static_cast<int>(y) - radius, 0, a.height - 1);
        for (std::size_t x = 0; x < wide; ++x) {
          const int column = std::clamp(static_cast<int>(x) - radius, 0, a.width - 1);
          const double level_a = a.at(column, row).*channel;
          const double level_b = (is_compared(mask, column, row) ? b : a).at(column, row).*channel;
          of_a.row(y)[x] = level_a;
          of_b.row(y)[x] = level_b;
          of_aa.row(y)[x] = level_a * level_a;
          of_bb.row(y)[x] = level_b * level_b;
          of_ab.row(y)[x] = level_a * level_b;
        }
      }
      const Plane mean_a = blurred(of_a, window), mean_b = blurred(of_b, window);
      const Plane mean_aa = blurred(of_aa, window), mean_bb = blurred(of_bb, window);
      const Plane mean_ab = blurred(of_ab, window);
      for (std::size_t i = 0; i < similarity.values.size(); ++i) {
        const double m_a = mean_a.values[i];
        const double m_b = mean_b.values[i];
        const double variance_a = mean_aa.values[i] - m_a * m_a;
        const double variance_b = mean_bb.values[i] - m_b * m_b;
        const double covariance = mean_ab.values[i] - m_a * m_b;
        similarity.values[i] +=
            (2 * (m_a * m_b) + stabilizer_1) * (2 * covariance + stabilizer_2) /
            ((m_a * m_a + m_b * m_b + stabilizer_1) * (variance_a + variance_b + stabilizer_2)) / 3;
      }
    }
    for (std::size_t y = 0; y < rows; ++y) {
      const int row = first + static_cast<int>(y);
      for (int x = 0; x < a.width; ++x) {
        if (counts(x, row))
          sums[static_cast<std::size_t>(row)] += similarity.row(y)[static_cast<std::size_t>(x)];
      }
    }
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0) / static_cast<double>(count);
}

std::string text_of(Rgb8 color) { return text("(%d, %d, %d)", color.r, color.g, color.b); }

Json json_of(Rgb8 color) { return Json::list({color.r, color.g, color.b}); }

Json json_of(const PixelBox& box) {
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

bool is_compared(const Image& mask, int column, int row) {
  return mask.pixels.empty() || mask.at(column, row) != Rgb8{};
}

void check_sizes(const Image& a, const Image& b, const Image& mask) {
  if (a.width != b.width || a.height != b.height) {
    throw DifferenceError("the pictures differ in size: " + size_of(a) + " and " + size_of(b) +
                          " pixels");
  }
  if (a.pixels.empty()) throw DifferenceError("the pictures are empty");
  if (!mask.pixels.empty() && (mask.width != a.width || mask.height != a.height)) {
    throw DifferenceError("the mask differs from the pictures in size: " + size_of(mask) + " and " +
                          size_of(a) + " pixels");
  }
}

Figures measure(const Image& a, const Image& b, const Image& mask, Detail detail) {
  check_sizes(a, b, mask);
  Figures figures;
  figures.width = a.width;
  figures.height = a.height;

  // One pass over the pixels. The sums are exact: at most 3 * 2^27 squares of 255.
  std::uint64_t absolute = 0, squared = 0, of_a = 0, of_b = 0;
  int left = a.width, right = -1, top = a.height, bottom = -1;
  for (int row = 0; row < a.height; ++row) {
    for (int column = 0; column < a.width; ++column) {
      if (!is_compared(mask, column, row)) continue;
      const Rgb8 p = a.at(column, row);
      const Rgb8 q = b.at(column, row);
      for (const auto channel : {&Rgb8::r, &Rgb8::g, &Rgb8::b}) {
        const auto apart = static_cast<std::uint64_t>(std::abs(p.*channel - q.*channel));
        absolute += apart;
        squared += apart * apart;
        of_a += p.*channel;
        of_b += q.*channel;
      }
      const int levels = channel_difference(p, q);
      ++figures.pixels_by_levels[static_cast<std::size_t>(levels)];
      if (levels == 0) continue;
      left = std::min(left, column);
      right = std::max(right, column);
      top = std::min(top, row);
      bottom = row;
      if (levels > figures.worst.levels) figures.worst = {column, row, levels, p, q};
    }
  }
  for (const std::size_t pixels : figures.pixels_by_levels) figures.pixels_compared += pixels;
  if (figures.pixels_compared == 0) throw DifferenceError("the mask leaves out every pixel");

  // Means.
  const auto pixels = static_cast<double>(figures.pixels_compared);
  figures.pixels_different = pixels_off_by_more_than(figures, 0);
  figures.share_different = static_cast<double>(figures.pixels_different) / pixels;
  figures.mean_absolute_error = static_cast<double>(absolute) / (3 * pixels);
  figures.root_mean_square_error = std::sqrt(static_cast<double>(squared) / (3 * pixels));
  figures.mean_a = static_cast<double>(of_a) / (3 * pixels);
  figures.mean_b = static_cast<double>(of_b) / (3 * pixels);
  figures.peak_signal_to_noise = std::numeric_limits<double>::infinity();
  if (figures.pixels_different == 0) return figures;  // with SSIM 1

  figures.peak_signal_to_noise = 20 * std::log10(255 / figures.root_mean_square_error);
  figures.box = {left, top, right - left + 1, bottom - top + 1};
  figures.structural_similarity = std::numeric_limits<double>::quiet_NaN();
  if (detail == Detail::pixels) return figures;
  figures.structural_similarity = mean_ssim(a, b, mask);
  return figures;
}

std::size_t pixels_off_by_more_than(const Figures& figures, int levels) {
  return std::accumulate(figures.pixels_by_levels.begin() + levels + 1,
                         figures.pixels_by_levels.end(), std::size_t{0});
}

std::string differing_pixels(const Figures& f) {
  const std::size_t off = pixels_off_by_more_than(f, 1);
  const double percent = 100 * static_cast<double>(off) / static_cast<double>(f.pixels_compared);
  return text("%zu of %zu pixels by more than one level (%.*g %%), %zu by one", off,
              f.pixels_compared, percent < 99.5 ? 2 : 3, percent, f.pixels_different - off);
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
