// Distances on the globe: each pixel passes its nearest marked pixel on to its neighbors.
#include "globe_grid.hpp"

#include <cmath>
#include <limits>

namespace texmap {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double earth_radius_km = 6371;
constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

double chord_squared(SpherePoint a, SpherePoint b) {
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return x * x + y * y + z * z;
}

/// Each pixel's nearest source so far. A sweep passes sources on within a row and to the next row.
class NearestSource {
 public:
  NearestSource(const GlobeGrid& grid, const std::vector<bool>& marks, bool source)
      : grid_(grid), source_(grid.size(), nowhere) {
    for (std::size_t i = 0; i < source_.size(); ++i)
      if (marks[i] == source) source_[i] = i;
  }

  void sweep(int first_row, int last_row) {
    const int step = last_row > first_row ? 1 : -1;
    for (int row = first_row;; row += step) {
      const int columns = grid_.columns();
      // Twice around, because a row is a circle.
      for (int i = 1; i < 2 * columns; ++i) offer(i % columns, row, (i - 1) % columns, row);
      for (int i = 2 * columns - 2; i >= 0; --i) offer(i % columns, row, (i + 1) % columns, row);
      if (row == last_row) return;
      for (int column = 0; column < columns; ++column)
        for (int side = -1; side <= 1; ++side) offer(column, row + step, column + side, row);
    }
  }

  [[nodiscard]] double kilometres(int column, int row) const {
    const double half_chord = std::sqrt(gap(source_[grid_.place(column, row)], column, row)) / 2;
    // The series of the arcsine: exact enough for a tint and the same on every machine.
    const double s = half_chord * half_chord;
    return 2 * earth_radius_km * half_chord * (1 + s / 6 + 3 * s * s / 40 + 5 * s * s * s / 112);
  }

 private:
  void offer(int column, int row, int from_column, int from_row) {
    const std::size_t offered = source_[grid_.place(from_column, from_row)];
    std::size_t& held = source_[grid_.place(column, row)];
    if (offered == nowhere || offered == held) return;
    if (held == nowhere || gap(offered, column, row) < gap(held, column, row)) held = offered;
  }

  [[nodiscard]] double gap(std::size_t source, int column, int row) const {
    const auto columns = static_cast<std::size_t>(grid_.columns());
    const SpherePoint there =
        grid_.point(static_cast<int>(source % columns), static_cast<int>(source / columns));
    return chord_squared(there, grid_.point(column, row));
  }

  const GlobeGrid& grid_;
  std::vector<std::size_t> source_;
};

}  // namespace

double sine_of_degrees(double degrees) {
  if (degrees > 90) degrees = 180 - degrees;
  if (degrees < -90) degrees = -180 - degrees;
  const double x = degrees * (pi / 180);
  double sum = 0, term = x;
  for (int n = 1; n <= 23; n += 2) {
    sum += term;
    term = -term * x * x / ((n + 1) * (n + 2));
  }
  return sum;
}

GlobeGrid::GlobeGrid(int columns, int rows) : columns_(columns), rows_(rows) {
  for (int column = 0; column < columns; ++column) {
    const double degrees = longitude(column);
    sin_longitude_.push_back(sine_of_degrees(degrees));
    cos_longitude_.push_back(sine_of_degrees(90 - std::abs(degrees)));
  }
  for (int row = 0; row < rows; ++row) {
    sin_latitude_.push_back(sine_of_degrees(latitude(row)));
    cos_latitude_.push_back(sine_of_degrees(90 - std::abs(latitude(row))));
  }
}

SpherePoint GlobeGrid::point(int column, int row) const {
  const auto i = static_cast<std::size_t>(column), j = static_cast<std::size_t>(row);
  return {cos_latitude_[j] * cos_longitude_[i], cos_latitude_[j] * sin_longitude_[i],
          sin_latitude_[j]};
}

std::size_t GlobeGrid::place(int column, int row) const {
  const int wrapped = column < 0           ? column + columns_
                      : column >= columns_ ? column - columns_
                                           : column;
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(wrapped);
}

std::vector<double> GlobeGrid::distance_to_other(const std::vector<bool>& marks) const {
  std::vector<double> distances(size());
  for (const bool source : {false, true}) {
    NearestSource nearest(*this, marks, source);
    for (int round = 0; round < 2; ++round) {
      nearest.sweep(0, rows_ - 1);
      nearest.sweep(rows_ - 1, 0);
    }
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const std::size_t i = place(column, row);
        if (marks[i] != source) distances[i] = nearest.kilometres(column, row);
      }
    }
  }
  return distances;
}

}  // namespace texmap
