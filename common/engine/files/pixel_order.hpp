// Which way the pixels of a file run over its picture.
#pragma once
#include "texture/image.hpp"

namespace texmap {

/// How a file's columns and rows become a picture's: mirrored first, then exchanged.
struct PixelOrder {
  bool from_right = false;     ///< the file's first column is its picture's last
  bool from_below = false;     ///< its first row is the last
  bool columns_first = false;  ///< its rows are then the picture's columns
  friend bool operator==(const PixelOrder&, const PixelOrder&) = default;

  /// A picture for a file of so many columns and rows.
  template <class Pixel>
  [[nodiscard]] Grid<Pixel> picture(int columns, int rows) const {
    return columns_first ? Grid<Pixel>(rows, columns) : Grid<Pixel>(columns, rows);
  }
  /// The pixel that the file has in a column and a row.
  template <class Pixel>
  [[nodiscard]] Pixel& at(Grid<Pixel>& picture, int column, int row) const {
    const int columns = columns_first ? picture.height : picture.width;
    const int rows = columns_first ? picture.width : picture.height;
    if (from_right) column = columns - 1 - column;
    if (from_below) row = rows - 1 - row;
    return columns_first ? picture.at(row, column) : picture.at(column, row);
  }
};

}  // namespace texmap
