// Laying one picture on another.
#pragma once
#include "texture/image.hpp"

namespace texmap {

/// Copies `picture` onto `sheet`, its upper left corner at (column, row), clipped to the sheet.
inline void blit(Image& sheet, const Image& picture, int column, int row) {
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int to_x = column + x;
      const int to_y = row + y;
      if (to_x >= 0 && to_x < sheet.width && to_y >= 0 && to_y < sheet.height)
        sheet.at(to_x, to_y) = picture.at(x, y);
    }
  }
}

}  // namespace texmap
