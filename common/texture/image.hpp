// An image in memory.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace texmap {

/// Red, green and blue of one pixel, 0 to 255.
struct Rgb8 {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb8&, const Rgb8&) = default;
};

/// A picture's pixels, row by row from the top, each row from the left.
template <class Pixel>
struct Grid {
  int width = 0;
  int height = 0;
  std::vector<Pixel> pixels;

  Grid() = default;
  Grid(int columns, int rows, const Pixel& fill = {})
      : width(columns),
        height(rows),
        pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), fill) {}

  /// The pixel in a column and a row, both from 0, rows from the top; not checked.
  [[nodiscard]] Pixel& at(int column, int row) { return pixels[place(column, row)]; }
  [[nodiscard]] const Pixel& at(int column, int row) const { return pixels[place(column, row)]; }

  friend bool operator==(const Grid&, const Grid&) = default;

 private:
  [[nodiscard]] std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }
};
using Image = Grid<Rgb8>;

/// Red, green and blue of one pixel in finer steps, 0 to 65535.
struct Rgb16 {
  std::uint16_t r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb16&, const Rgb16&) = default;
};
using DeepImage = Grid<Rgb16>;

/// A picture that cannot be changed. Its copies share the pixels.
template <class Pixel>
class SharedGrid {
 public:
  int width = 0;
  int height = 0;
  std::span<const Pixel> pixels;  ///< as in Grid

  SharedGrid() = default;
  SharedGrid(Grid<Pixel> grid) : whole_(std::make_shared<const Grid<Pixel>>(std::move(grid))) {
    width = whole_->width;
    height = whole_->height;
    pixels = whole_->pixels;
  }

  /// The pixel in a column and a row, as Grid::at.
  [[nodiscard]] const Pixel& at(int column, int row) const {
    return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column)];
  }
  operator const Grid<Pixel>&() const { return *whole_; }

 private:
  std::shared_ptr<const Grid<Pixel>> whole_ = std::make_shared<const Grid<Pixel>>();
};
using SharedImage = SharedGrid<Rgb8>;

/// The picture with the color in each pixel that `color_at` gives for its column and row.
template <class ColorAt>
[[nodiscard]] auto image_of(int width, int height, const ColorAt& color_at) {
  Grid<decltype(color_at(0, 0))> image(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) image.at(column, row) = color_at(column, row);
  }
  return image;
}

}  // namespace texmap
