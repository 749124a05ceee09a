// The pixels of an equirectangular map as points of the unit sphere.
#pragma once
#include <cstddef>
#include <vector>

namespace texmap {

/// Sine of an angle in degrees, -180 to 180, by + - * / only: C libraries differ in the last bits.
[[nodiscard]] double sine_of_degrees(double degrees);

struct SpherePoint {
  double x = 0, y = 0, z = 0;
};

/// `columns` meridians eastward from longitude -180, `rows` parallels from 90 degrees to -90.
class GlobeGrid {
 public:
  GlobeGrid(int columns, int rows);

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] double longitude(int column) const { return 360.0 * column / columns_ - 180; }
  [[nodiscard]] double latitude(int row) const { return 90 - 180.0 * row / (rows_ - 1); }
  [[nodiscard]] double cosine_of_latitude(int row) const {
    return cos_latitude_[static_cast<std::size_t>(row)];
  }
  [[nodiscard]] SpherePoint point(int column, int row) const;

  /// Index of a pixel in an array of all; the column may be -1 or columns() and then wraps around.
  [[nodiscard]] std::size_t place(int column, int row) const;
  [[nodiscard]] std::size_t size() const { return place(0, rows_); }

  /// For each pixel, the distance in kilometres to the nearest pixel with the other mark.
  ///
  /// @param marks  one for each pixel; both values occur
  [[nodiscard]] std::vector<double> distance_to_other(const std::vector<bool>& marks) const;

 private:
  int columns_;
  int rows_;
  std::vector<double> cos_longitude_, sin_longitude_, cos_latitude_, sin_latitude_;
};

}  // namespace texmap
