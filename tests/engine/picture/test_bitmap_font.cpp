// Writing on pictures.
#include <doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/picture/bitmap_font.hpp"

namespace {

using texmap::Image;
using texmap::Rgb8;
using texmap::text_width;

constexpr Rgb8 paper{10, 20, 30};
constexpr Rgb8 ink{200, 100, 50};

Image written(std::string_view text, int column, int row, int scale, int width, int height) {
  Image image(width, height, paper);
  texmap::draw_text(image, column, row, text, ink, scale);
  return image;
}

std::vector<bool> shape(std::string_view text) {
  std::vector<bool> dots;
  for (const Rgb8 pixel :
       written(text, 0, 0, 1, texmap::letter_columns, texmap::letter_rows).pixels)
    dots.push_back(pixel == ink);
  return dots;
}

}  // namespace

TEST_CASE("every character has its own shape, with ink and a column without it between letters") {
  std::vector<std::string> all;
  for (char c = ' '; c <= '~'; ++c) all.emplace_back(1, c);
  // At last the box of characters that the font does not have.
  for (const char* other : {"°", "×", "←", "↑", "→", "↓", "é"}) all.emplace_back(other);
  std::set<std::vector<bool>> shapes;
  for (const std::string& character : all) {
    CAPTURE(character);
    const std::vector<bool> dots = shape(character);
    CHECK(shapes.insert(dots).second);
    bool inked = false, between = false;
    for (std::size_t i = 0; i < dots.size(); ++i) {
      inked = inked || dots[i];
      between = between || (dots[i] && i % texmap::letter_columns == texmap::letter_columns - 1);
    }
    CHECK(inked == (character != " "));
    CHECK_FALSE(between);
  }
  CHECK(shape("\xff") == shape("é"));  // the box serves for what is not UTF-8 too
}

TEST_CASE("a text is as wide as its letters and the spaces between them") {
  CHECK(text_width("") == 0);
  CHECK(text_width("H") == 5);
  CHECK(text_width("HH", 3) == 33);
  CHECK(text_width("60°N") == text_width("60.N"));
}

// Each dot of a letter is `scale` pixels wide and high, and the next letter begins a column of dots
// further; across or beyond an edge a text is the part of it that lies inside.
TEST_CASE("a text is drawn letter by letter, and cut at the edges of the picture") {
  constexpr int width = 23, height = 13;
  const std::vector<std::vector<bool>> letters = {shape("W"), shape("#"), shape("°")};
  for (const int scale : {1, 2, 7}) {
    for (int row = -60; row <= 20; row += 3) {
      for (int column = -130; column <= 30; column += 5) {
        Image expected(width, height, paper);
        for (int y = std::max(row, 0); y < height; ++y) {
          for (int x = std::max(column, 0); x < width; ++x) {
            const int dot_column = (x - column) / scale, dot_row = (y - row) / scale;
            if (dot_column >= 18 || dot_row >= 8) continue;
            const auto dot = static_cast<std::size_t>(dot_row * 6 + dot_column % 6);
            if (letters[static_cast<std::size_t>(dot_column / 6)][dot]) expected.at(x, y) = ink;
          }
        }
        CAPTURE(scale);
        CAPTURE(row);
        CAPTURE(column);
        REQUIRE(written("W#°", column, row, scale, width, height) == expected);
      }
    }
  }
  CHECK(written("text", 1000000, -1000000, 5, 8, 8) == Image(8, 8, paper));
  CHECK(written("text", 0, 0, 1, 0, 0) == Image(0, 0, paper));
}
