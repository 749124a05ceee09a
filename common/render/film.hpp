// Light gathered over many samples, and how sure it is.
#pragma once
#include <cmath>
#include <memory>
#include <mutex>

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

  /// Says that a drawing of so many more samples in each half begins; count() says that it has ended.
  void begin(long first, long second) {
    const std::lock_guard guard(*lock_);
    drawing_first_ = first_ + first;
    drawing_second_ = second_ + second;
    difference_ = 0;
    rows_done_ = 0;
  }
  /// Says that a row has all its samples of the drawing. Different rows may be said by different threads.
  void finish_row(int row) {
    if (drawing_first_ == 0 || drawing_second_ == 0) return;
    const double difference = row_difference(row, drawing_first_, drawing_second_);
    const std::lock_guard guard(*lock_);
    difference_ += difference;
    ++rows_done_;
  }
  /// The estimated error of the rows that are finished, as error() has it; +infinity where there are none. May be asked by any
  /// thread.
  [[nodiscard]] double error_so_far() const {
    const std::lock_guard guard(*lock_);
    return rows_done_ == 0 ? infinity<double>() : error_of(difference_, rows_done_);
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
    for (int row = 0; row < height_; ++row) sum += row_difference(row, first_, second_);
    return error_of(sum, height_);
  }

 private:
  struct Pixel {
    Rgb first, second;
  };

  /// The squares of the differences between the means of the two halves, summed over a row and its channels.
  [[nodiscard]] double row_difference(int row, long first, long second) const {
    const double a = 1.0 / static_cast<double>(first);
    const double b = 1.0 / static_cast<double>(second);
    double sum = 0;
    for (int column = 0; column < width_; ++column) {
      const Pixel& pixel =
          pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)];
      sum += square(pixel.first.r * a - pixel.second.r * b) + square(pixel.first.g * a - pixel.second.g * b) +
             square(pixel.first.b * a - pixel.second.b * b);
    }
    return sum;
  }
  [[nodiscard]] double error_of(double difference, int rows) const { return std::sqrt(difference / (3.0 * width_ * rows)) / 2; }
  int width_;
  int height_;
  LargeArray<Pixel> pixels_;
  long first_ = 0;
  long second_ = 0;
  // Of the drawing under way. A film can be moved and copied, a lock cannot.
  std::shared_ptr<std::mutex> lock_ = std::make_shared<std::mutex>();
  long drawing_first_ = 0;
  long drawing_second_ = 0;
  double difference_ = 0;
  int rows_done_ = 0;
};

}  // namespace texmap
