// Letters of square blocks, for textures: no texel is between ink and paper.
#pragma once
#include <string_view>

#include "engine/files/utf8.hpp"
#include "texture/image.hpp"

namespace texmap {

inline constexpr std::u32string_view block_characters = U"0123456789.=+\u00b0uvDEHINPSTUW";

/// The first thirteen characters, then the others: seven rows of five dots each.
inline constexpr const char* block_rows[] = {
    ".###. ..#.. .###. .###. ...#. ##### .###. ##### .###. .###. ..... ..... .....",
    "#...# .##.. #...# #...# ..##. #.... #.... ....# #...# #...# ..... ..... ..#..",
    "#..## #.#.. ....# ....# .#.#. ####. #.... ...#. #...# #...# ..... ##### ..#..",
    "#.#.# ..#.. ..##. ..##. #..#. ....# ####. ...#. .###. .#### ..... ..... #####",
    "##..# ..#.. .#... ....# ##### ....# #...# ..#.. #...# ....# ..... ##### ..#..",
    "#...# ..#.. #.... #...# ...#. #...# #...# ..#.. #...# ....# .##.. ..... ..#..",
    ".###. ##### ##### .###. ...#. .###. .###. ..#.. .###. .###. .##.. ..... .....",
    ".##.. ..... ..... ####. ##### #...# .###. #...# ####. .#### ##### #...# #...#",
    "#..#. ..... ..... #...# #.... #...# ..#.. ##..# #...# #.... ..#.. #...# #...#",
    "#..#. #...# #...# #...# #.... #...# ..#.. ##..# #...# #.... ..#.. #...# #...#",
    ".##.. #...# #...# #...# ####. ##### ..#.. #.#.# ####. .###. ..#.. #...# #.#.#",
    "..... #...# #...# #...# #.... #...# ..#.. #..## #.... ....# ..#.. #...# #.#.#",
    "..... #...# .#.#. #...# #.... #...# ..#.. #..## #.... ....# ..#.. #...# ##.##",
    "..... .#### ..#.. ####. ##### #...# .###. #...# #.... ####. ..#.. .###. #...#",
};

/// Writes a text, `scale` pixels to a dot, and returns its width. What is outside is left out.
inline int draw_blocks(Image& image, int column, int row, std::string_view text, Rgb8 color,
                       int scale) {
  int left = column;
  for (; !text.empty(); left += 6 * scale) {
    const auto at = static_cast<int>(block_characters.find(take_character(text)));
    for (int y = 0; at >= 0 && y < 7 * scale; ++y) {
      for (int x = 0; x < 5 * scale; ++x) {
        if (left + x < 0 || left + x >= image.width || row + y < 0 || row + y >= image.height)
          continue;
        if (block_rows[at / 13 * 7 + y / scale][at % 13 * 6 + x / scale] == '#')
          image.at(left + x, row + y) = color;
      }
    }
  }
  return left - scale - column;
}

inline int block_width(std::string_view text, int scale) {
  Image nowhere;
  return draw_blocks(nowhere, 0, 0, text, {}, scale);
}

}  // namespace texmap
