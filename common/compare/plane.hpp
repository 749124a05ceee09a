// A rectangle of numbers, and filters that run over it one direction at a time.
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace texmap {

/// Numbers in rows from the top, each row from the left.
class Plane {
 public:
  Plane(int width, int rows)
      : width_(width), rows_(rows), values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(rows)) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] double* row(int y) { return values_.data() + place(y); }
  [[nodiscard]] const double* row(int y) const { return values_.data() + place(y); }

 private:
  [[nodiscard]] std::size_t place(int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_); }

  int width_;
  int rows_;
  std::vector<double> values_;
};

/// The weights of a filter in one direction, at the distances -radius to radius; an odd number of them.
using Kernel = std::vector<double>;

[[nodiscard]] inline int radius_of(const Kernel& kernel) { return static_cast<int>(kernel.size() / 2); }

/// The bell exp(-x^2 / (2 sigma^2)) at the distances -radius to radius, divided by its sum.
///
/// @param sigma   pixels, above 0
/// @param radius  pixels, 0 or more
[[nodiscard]] Kernel bell(double sigma, int radius);

/// Filters each row. Only where the whole kernel lies inside: the result is narrower by the radius at both ends.
///
/// Two filters after each other, one across and one down, are one of two dimensions whose weights are the products of theirs,
/// at a cost that grows with the kernel's side and not with its area.
[[nodiscard]] Plane filtered_across(const Plane& plane, const Kernel& kernel);

/// Filters each column; the result is lower by the radius at both ends.
[[nodiscard]] Plane filtered_down(const Plane& plane, const Kernel& kernel);

/// Some rows of a picture and what lies around them.
///
/// Whole pictures of numbers would take gigabytes for the largest pictures; bands take megabytes.
struct Band {
  int first = 0;   // row of the picture
  int rows = 0;    // how many
  int margin = 0;  // pixels at each of the four sides
};

/// Calls `work` for one band after another until all rows of a picture of this height were in one.
void for_each_band(int height, int margin, const std::function<void(const Band&)>& work);

/// Where the pixels of a band and its margin come from: `size` places, -margin to size - margin - 1 from `first` on, and beyond
/// an edge of the picture the pixel at the edge, again and again.
///
/// @param side  columns or rows of the picture
[[nodiscard]] std::vector<int> with_repeated_edges(int first, int count, int margin, int side);

/// Takes the values of one row of a picture.
using TakeRow = std::function<void(int row, std::span<const double> values)>;

}  // namespace texmap
