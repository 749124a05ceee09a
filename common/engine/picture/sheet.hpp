// Sheets: pictures with lines of text above and below them.
#pragma once
#include <string_view>

#include "engine/picture/bitmap_font.hpp"
#include "engine/picture/blit.hpp"

namespace texmap {

/// A column of a sheet, filled from the top: each line and each picture goes below the one before.
struct SheetColumn {
  Image& sheet;
  int left, top;
  int scale;              ///< of letters
  int line = 12 * scale;  ///< height of a line of text
  int above = 2 * scale;  ///< of it the space over its letters
  int indent = 0;         ///< of letters, to the right
  Rgb8 ink{20, 20, 20};

  void write(std::string_view words) { write(words, ink); }
  void write(std::string_view words, Rgb8 color) {
    draw_text(sheet, left + indent, top + above, words, color, scale);
    top += line;
  }
  void lay(const Image& picture) {
    blit(sheet, picture, left, top);
    top += picture.height;
  }
};

}  // namespace texmap
