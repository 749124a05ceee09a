// The figures of two pictures: one pass over the pixels, then SSIM.
#include "engine/compare/difference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "engine/compare/ssim.hpp"

namespace texmap {
namespace {

std::string size_of(const Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height);
}

}  // namespace

int channel_difference(Rgb8 p, Rgb8 q) {
  return std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
}

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

  // One pass over the pixels. The sums are exact: at most 3 * 2^26 squares of 255.
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

}  // namespace texmap
