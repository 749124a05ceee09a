// Structural similarity: five blurred planes for each channel, then one formula.
#include "engine/compare/ssim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "engine/compare/difference.hpp"
#include "engine/render/threads.hpp"

namespace texmap {
namespace {

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
    weight = std::exp(-x * x / (2 * window_sigma * window_sigma));
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

}  // namespace

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

}  // namespace texmap
