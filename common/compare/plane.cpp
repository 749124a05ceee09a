// The filters: sums of shifted rows, which compilers turn into vector instructions.
#include "plane.hpp"

#include <algorithm>
#include <cmath>

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
    for (const double weight : kernel) add_scaled(result.row(y), plane.row(from++), weight, result.width());
  }
  return result;
}

void for_each_band(int height, int margin, const std::function<void(const Band&)>& work) {
  for (int first = 0; first < height; first += rows_of_a_band) {
    work({.first = first, .rows = std::min(rows_of_a_band, height - first), .margin = margin});
  }
}

std::vector<int> with_repeated_edges(int first, int count, int margin, int side) {
  std::vector<int> places;
  for (int i = first - margin; i < first + count + margin; ++i) places.push_back(std::clamp(i, 0, side - 1));
  return places;
}

}  // namespace texmap
