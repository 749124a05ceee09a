// Sheets: pictures with lines of text above and below them.
#pragma once
#include <algorithm>
#include <string>
#include <string_view>

#include "engine/files/blit.hpp"
#include "engine/files/sheet_image.hpp"
#include "engine/files/stroke_font.hpp"

namespace texmap {

/// A column of a sheet, filled from the top: each line and each picture goes below the one before.
struct SheetColumn {
  SheetImage& sheet;
  int left, top;
  int scale;              ///< pixels to one where letters are small
  int line = 12 * scale;  ///< height of a line of text
  int above = 2 * scale;  ///< of it the space over its letters
  int indent = 0;         ///< of letters, to the right
  Rgb8 ink{20, 20, 20};
  int size = std::max(11, 10 * scale);  ///< of letters

  void write(std::string_view words) { write(words, ink); }
  void write(std::string_view words, Rgb8 color) {
    sheet.parts.push_back({std::string(words), left, top});
    draw_text(sheet, left + indent, top + above, words, color, size);
    top += line;
  }
  void lay(const Image& picture) {
    sheet.parts.push_back({"", left, top, picture.width, picture.height});
    blit(sheet, picture, left, top);
    top += picture.height;
  }
};

}  // namespace texmap
