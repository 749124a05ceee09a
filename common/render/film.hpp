// Light gathered over many samples, and how sure it is.
#pragma once
#include <cmath>
#include <vector>

#include "color.hpp"
#include "image.hpp"

namespace texmap {

/// The light of a picture, pixel by pixel.
///
/// The first half of the samples and the second are pictures of the same light with errors of their own, so that half their
/// difference tells what the whole is off by: about that for random samples; less, for patterns whose halves are worse than the
/// whole.
class Film {
 public:
  Film(int width, int height)
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  /// Adds the sums of the first and of the second half of one pixel's samples. Different pixels may be added to by different
  /// threads.
  void add(int column, int row, const Rgb& first, const Rgb& second) {
    Pixel& pixel = pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)];
    pixel.first = pixel.first + first;
    pixel.second = pixel.second + second;
  }
  /// Says that every pixel got so many samples more in each half.
  void count(long first, long second) {
    first_ += first;
    second_ += second;
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] long samples() const { return first_ + second_; }
  /// The mean light of a pixel.
  [[nodiscard]] Rgb light(int column, int row) const {
    const Pixel& pixel =
        pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)];
    return (pixel.first + pixel.second) * (1.0 / static_cast<double>(samples()));
  }
  /// The estimated error: root mean square over pixels and channels, in units of light; +infinity before both halves have some.
  [[nodiscard]] double error() const {
    if (first_ == 0 || second_ == 0) return infinity<double>();
    double sum = 0;
    const double a = 1.0 / static_cast<double>(first_);
    const double b = 1.0 / static_cast<double>(second_);
    for (const Pixel& pixel : pixels_) {
      sum += square(pixel.first.r * a - pixel.second.r * b) + square(pixel.first.g * a - pixel.second.g * b) +
             square(pixel.first.b * a - pixel.second.b * b);
    }
    return std::sqrt(sum / (3 * static_cast<double>(pixels_.size()))) / 2;
  }

 private:
  struct Pixel {
    Rgb first, second;
  };
  int width_;
  int height_;
  std::vector<Pixel> pixels_;
  long first_ = 0;
  long second_ = 0;
};

}  // namespace texmap
