// SSIM without any of the tested code: each sum runs over a whole two-dimensional window and
// nothing is reused. Slow, but easy to compare with the paper.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "texture/image.hpp"

namespace texmap::test::naive {

/// The pixel, or the nearest one of the picture.
inline Rgb8 pixel(const Image& image, int column, int row) {
  return image.at(std::clamp(column, 0, image.width - 1), std::clamp(row, 0, image.height - 1));
}

inline std::array<double, 3> levels(Rgb8 p) { return {double(p.r), double(p.g), double(p.b)}; }

/// SSIM at one pixel: the sums of equations 14 to 16 of the paper, with centered differences.
inline double ssim(const Image& a, const Image& b, int column, int row) {
  double sum = 0;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto weighted = [&](const std::function<double(double, double)>& of) {
      double top = 0, bottom = 0;
      for (int dy = -5; dy <= 5; ++dy) {
        for (int dx = -5; dx <= 5; ++dx) {
          const double weight = std::exp(-(dx * dx + dy * dy) / 4.5);
          top += weight * of(levels(pixel(a, column + dx, row + dy))[channel],
                             levels(pixel(b, column + dx, row + dy))[channel]);
          bottom += weight;
        }
      }
      return top / bottom;
    };
    const double ma = weighted([](double x, double) { return x; });
    const double mb = weighted([](double, double y) { return y; });
    const double vaa = weighted([&](double x, double) { return (x - ma) * (x - ma); });
    const double vbb = weighted([&](double, double y) { return (y - mb) * (y - mb); });
    const double vab = weighted([&](double x, double y) { return (x - ma) * (y - mb); });
    sum += (2 * ma * mb + 6.5025) * (2 * vab + 58.5225) /
           ((ma * ma + mb * mb + 6.5025) * (vaa + vbb + 58.5225));
  }
  return sum / 3;
}

}  // namespace texmap::test::naive
