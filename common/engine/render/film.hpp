// A film: light gathered over many samples, and its estimated error.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "math/color.hpp"

namespace texmap {

/// The sum of the squared differences of what two colors' channels show: light above 1 counts as 1.
[[nodiscard]] inline double visible_difference(const Rgb& a, const Rgb& b) {
  return square(min(a.r, 1.0) - min(b.r, 1.0)) + square(min(a.g, 1.0) - min(b.g, 1.0)) +
         square(min(a.b, 1.0) - min(b.b, 1.0));
}

/// The error of the mean, estimated from its two halves: half their difference, root mean square
/// over pixels and channels. Patterns that are worse in halves have smaller errors than this.
///
/// @param squared_differences  of the halves' means, summed over `pixels` pixels
[[nodiscard]] inline double error_of_halves(double squared_differences, double pixels) {
  return std::sqrt(squared_differences / (3 * pixels)) / 2;
}

/// The light of a picture: the mean of each pixel's samples.
class Film {
 public:
  Film(int width, int height, long samples)
      : width_(width),
        height_(height),
        samples_(samples),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] long samples() const { return samples_; }
  [[nodiscard]] Rgb light(int column, int row) const { return pixels_[place(column, row)]; }
  [[nodiscard]] const Rgb* row(int row) const { return pixels_.data() + place(0, row); }
  void set_row(int row, const Rgb* light) {
    std::copy(light, light + width_, &pixels_[place(0, row)]);
  }
  void set_light(int column, int row, const Rgb& mean) { pixels_[place(column, row)] = mean; }

  /// Adds the samples of another film of the same size.
  void add(const Film& other) {
    const auto all = static_cast<double>(samples_ + other.samples_);
    const double ours = static_cast<double>(samples_) / all;
    const double theirs = static_cast<double>(other.samples_) / all;
    for (std::size_t i = 0; i < pixels_.size(); ++i)
      pixels_[i] = pixels_[i] * ours + other.pixels_[i] * theirs;
    samples_ += other.samples_;
  }

  /// The error of two halves of one size.
  [[nodiscard]] friend double error_of_halves(const Film& first, const Film& second) {
    double sum = 0;
    for (std::size_t i = 0; i < first.pixels_.size(); ++i)
      sum += visible_difference(first.pixels_[i], second.pixels_[i]);
    return error_of_halves(sum, static_cast<double>(first.pixels_.size()));
  }

  /// Estimated error of the mean, root mean square in units of light; +infinity if unknown.
  double error = infinity<double>();

 private:
  [[nodiscard]] std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column);
  }

  int width_;
  int height_;
  long samples_;
  std::vector<Rgb> pixels_;
};

}  // namespace texmap
