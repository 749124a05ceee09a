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

  /// The picture of a file with so many columns and rows.
  ///
  /// @param pixel_at  the file's pixel in a column and a row; called row by row
  template <class PixelAt>
  [[nodiscard]] auto picture(int columns, int rows, const PixelAt& pixel_at) const {
    using Picture = Grid<decltype(pixel_at(0, 0))>;
    Picture picture = columns_first ? Picture(rows, columns) : Picture(columns, rows);
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const int x = from_right ? columns - 1 - column : column;
        const int y = from_below ? rows - 1 - row : row;
        (columns_first ? picture.at(y, x) : picture.at(x, y)) = pixel_at(column, row);
      }
    }
    return picture;
  }
};

}  // namespace texmap
