// The filters: sums of shifted rows, which compilers turn into vector instructions.
#include "engine/compare/plane.hpp"

#include <algorithm>
#include <cmath>

#include "engine/render/threads.hpp"

namespace texmap {
namespace {

constexpr int rows_of_a_band = 64;

void add_scaled(double* sum, const double* row, double weight, int width) {
  for (int x = 0; x < width; ++x) sum[x] += weight * row[x];
}

}  // namespace

Kernel bell(double sigma, int radius) {
  Kernel kernel;
  double sum = 0;
  for (int x = -radius; x <= radius; ++x) {
    kernel.push_back(std::exp(-x * x / (2 * sigma * sigma)));
    sum += kernel.back();
  }
  for (double& weight : kernel) weight /= sum;
  return kernel;
}

Plane filtered_across(const Plane& plane, const Kernel& kernel) {
  Plane result(plane.width() - 2 * radius_of(kernel), plane.rows());
  for (int y = 0; y < result.rows(); ++y) {
    const double* from = plane.row(y);
    for (const double weight : kernel) add_scaled(result.row(y), from++, weight, result.width());
  }
  return result;
}

Plane filtered_down(const Plane& plane, const Kernel& kernel) {
  Plane result(plane.width(), plane.rows() - 2 * radius_of(kernel));
  for (int y = 0; y < result.rows(); ++y) {
    int from = y;
    for (const double weight : kernel)
      add_scaled(result.row(y), plane.row(from++), weight, result.width());
  }
  return result;
}

Plane filtered(const Plane& plane, const Kernel& across, const Kernel& down) {
  return filtered_down(filtered_across(plane, across), down);
}

void for_each_band(int height, int margin, const std::function<void(const Band&)>& work) {
  const int bands = (height + rows_of_a_band - 1) / rows_of_a_band;
  for_each_row(bands, 0, {}, [&](int band) {
    const int first = band * rows_of_a_band;
    work({.first = first, .rows = std::min(rows_of_a_band, height - first), .margin = margin});
  });
}

Image cut_out(const Image& image, const Band& band) {
  Image part(image.width + 2 * band.margin, band.rows + 2 * band.margin);
  for (int row = 0; row < part.height; ++row) {
    const int from = std::clamp(band.first + row - band.margin, 0, image.height - 1);
    for (int column = 0; column < part.width; ++column) {
      part.at(column, row) = image.at(std::clamp(column - band.margin, 0, image.width - 1), from);
    }
  }
  return part;
}

}  // namespace texmap
