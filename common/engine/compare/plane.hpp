// A rectangle of numbers, and filters that run over its rows and columns.
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "texture/image.hpp"

namespace texmap {

/// Numbers in rows from the top, each row from the left.
class Plane {
 public:
  Plane(int width, int rows)
      : width_(width),
        rows_(rows),
        values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(rows)) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] double* row(int y) { return values_.data() + place(y); }
  [[nodiscard]] const double* row(int y) const { return values_.data() + place(y); }

 private:
  [[nodiscard]] std::size_t place(int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
  }

  int width_;
  int rows_;
  std::vector<double> values_;
};

/// The weights of a one-dimensional filter at the distances -radius to radius: an odd number.
using Kernel = std::vector<double>;

[[nodiscard]] inline int radius_of(const Kernel& kernel) {
  return static_cast<int>(kernel.size() / 2);
}

/// The Gaussian exp(-x^2 / (2 sigma^2)) at the distances -radius to radius, divided by its sum.
///
/// @param sigma   pixels, above 0
/// @param radius  pixels, 0 or more
[[nodiscard]] Kernel bell(double sigma, int radius);

/// Filters each row where the whole kernel lies inside: the result is narrower by two radii.
[[nodiscard]] Plane filtered_across(const Plane& plane, const Kernel& kernel);

/// Filters each column; the result has two radii fewer rows.
[[nodiscard]] Plane filtered_down(const Plane& plane, const Kernel& kernel);

/// Filters rows, then columns: the two-dimensional filter with the products of both as weights.
[[nodiscard]] Plane filtered(const Plane& plane, const Kernel& across, const Kernel& down);

/// Some rows of a picture and the pixels around them. Working in bands keeps memory small.
struct Band {
  int first = 0;   // row of the picture
  int rows = 0;    // how many
  int margin = 0;  // pixels at each of the four sides
};

/// Calls `work` for each band of a picture of this height, on all cores.
void for_each_band(int height, int margin, const std::function<void(const Band&)>& work);

/// The pixels of a band and its margin. Outside the picture, the pixels at its edge repeat.
[[nodiscard]] Image cut_out(const Image& image, const Band& band);

/// Receives the values of one row of a picture: each row once, in any order and from any thread.
using TakeRow = std::function<void(int row, std::span<const double> values)>;

}  // namespace texmap
