// A film: light gathered over many samples, and its estimated error.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "math/color.hpp"
#include "texture/image.hpp"

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
  Film(int width, int height, long samples) : mean_(width, height), samples_(samples) {}

  [[nodiscard]] int width() const { return mean_.width; }
  [[nodiscard]] int height() const { return mean_.height; }
  [[nodiscard]] long samples() const { return samples_; }
  [[nodiscard]] const Rgb& light(int column, int row) const { return mean_.at(column, row); }
  [[nodiscard]] const Rgb* row(int row) const { return &mean_.at(0, row); }
  void set_row(int row, const Rgb* light) {
    std::copy(light, light + mean_.width, &mean_.at(0, row));
  }
  void set_light(int column, int row, const Rgb& mean) { mean_.at(column, row) = mean; }

  /// Adds the samples of another film of the same size.
  void add(const Film& other) {
    const auto all = static_cast<double>(samples_ + other.samples_);
    const double ours = static_cast<double>(samples_) / all;
    const double theirs = static_cast<double>(other.samples_) / all;
    for (std::size_t i = 0; i < mean_.pixels.size(); ++i)
      mean_.pixels[i] = mean_.pixels[i] * ours + other.mean_.pixels[i] * theirs;
    samples_ += other.samples_;
  }

  /// The error of two halves of one size.
  [[nodiscard]] friend double error_of_halves(const Film& first, const Film& second) {
    double sum = 0;
    for (std::size_t i = 0; i < first.mean_.pixels.size(); ++i)
      sum += visible_difference(first.mean_.pixels[i], second.mean_.pixels[i]);
    return error_of_halves(sum, static_cast<double>(first.mean_.pixels.size()));
  }

  /// Estimated error of the mean, root mean square in units of light; +infinity if unknown.
  double error = infinity<double>();

 private:
  Grid<Rgb> mean_;
  long samples_;
};

}  // namespace texmap
