// Sheets: pictures with lines of text above and below them.
#pragma once
#include <algorithm>
#include <functional>
#include <string_view>

#include "engine/files/blit.hpp"
#include "engine/files/stroke_font.hpp"

namespace texmap {

/// What a sheet gets: a picture, or a line of text, which has no size.
struct SheetPart {
  std::string_view words;
  int left, top, width = 0, height = 0;
};

/// Called with each part, if somebody asks: the book shows a sheet's pictures with their words as
/// text (docs/sheets.txt).
inline std::function<void(const SheetPart& part)> on_sheet_part;

/// A column of a sheet, filled from the top: each line and each picture goes below the one before.
struct SheetColumn {
  Image& sheet;
  int left, top;
  int scale;              ///< pixels to one where letters are small
  int line = 12 * scale;  ///< height of a line of text
  int above = 2 * scale;  ///< of it the space over its letters
  int indent = 0;         ///< of letters, to the right
  Rgb8 ink{20, 20, 20};
  int size = std::max(11, 10 * scale);  ///< of letters

  void write(std::string_view words) { write(words, ink); }
  void write(std::string_view words, Rgb8 color) {
    if (on_sheet_part) on_sheet_part({words, left, top});
    draw_text(sheet, left + indent, top + above, words, color, size);
    top += line;
  }
  void lay(const Image& picture) {
    if (on_sheet_part) on_sheet_part({"", left, top, picture.width, picture.height});
    blit(sheet, picture, left, top);
    top += picture.height;
  }
};

}  // namespace texmap
