// Writing on pictures.
#include <doctest.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/picture/bitmap_font.hpp"

namespace {

using texmap::draw_text;
using texmap::Image;
using texmap::Rgb8;
using texmap::text_width;

constexpr Rgb8 paper{10, 20, 30};
constexpr Rgb8 ink{200, 100, 50};

/// Every character the font has.
std::vector<std::string> characters() {
  std::vector<std::string> all;
  for (char c = ' '; c <= '~'; ++c) all.emplace_back(1, c);
  for (const char* other : {"°", "×", "←", "↑", "→", "↓"}) all.emplace_back(other);
  return all;
}

Image written(std::string_view text, int column, int row, int scale, int width, int height) {
  Image image(width, height, paper);
  draw_text(image, column, row, text, ink, scale);
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

TEST_CASE("every character has its own shape") {
  std::set<std::vector<bool>> shapes;
  for (const std::string& character : characters()) {
    CAPTURE(character);
    CHECK(shapes.insert(shape(character)).second);
  }
  CHECK(shapes.size() == 95 + 6);
  CHECK(shapes.insert(shape("é")).second);  // the box of characters that the font does not have
  CHECK_FALSE(shapes.insert(shape("\xff")).second);  // it serves for what is not UTF-8 too
}

TEST_CASE("every character but the space has ink, and none has ink in the column between letters") {
  for (const std::string& character : characters()) {
    CAPTURE(character);
    const std::vector<bool> dots = shape(character);
    int inked = 0, between = 0;
    for (std::size_t i = 0; i < dots.size(); ++i) {
      inked += dots[i] ? 1 : 0;
      between += dots[i] && i % texmap::letter_columns == texmap::letter_columns - 1 ? 1 : 0;
    }
    CHECK((inked > 0) == (character != " "));
    CHECK(between == 0);
  }
}

TEST_CASE("a text is as wide as its letters and the spaces between them") {
  CHECK(text_width("") == 0);
  CHECK(text_width("H") == 5);
  CHECK(text_width("HH") == 11);
  CHECK(text_width("HH", 3) == 33);
  CHECK(text_width("60°N") == text_width("60.N"));
  CHECK(text_width("→", 2) == 10);
}

TEST_CASE("a text of scale n is the text of scale 1 with every dot n pixels wide and high") {
  const std::string text = "Ag 4°";
  const int width = text_width(text);
  const Image small = written(text, 0, 0, 1, width, texmap::letter_rows);
  for (const int scale : {2, 3, 7}) {
    const Image large = written(text, 0, 0, scale, width * scale, texmap::letter_rows * scale);
    int different = 0;
    for (int row = 0; row < large.height; ++row)
      for (int column = 0; column < large.width; ++column)
        different += large.at(column, row) == small.at(column / scale, row / scale) ? 0 : 1;
    CAPTURE(scale);
    CHECK(different == 0);
  }
}

TEST_CASE("text across or beyond an edge is the part of it that lies inside") {
  constexpr int width = 23, height = 13, margin = 60;
  const std::string text = "W#g";
  for (int row = -30; row <= 20; ++row)
    for (int column = -50; column <= 30; ++column) {
      const Image clipped = written(text, column, row, 2, width, height);
      const Image whole =
          written(text, column + margin, row + margin, 2, width + 2 * margin, height + 2 * margin);
      int different = 0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          different += clipped.at(x, y) == whole.at(x + margin, y + margin) ? 0 : 1;
      CAPTURE(row);
      CAPTURE(column);
      REQUIRE(different == 0);
      REQUIRE(clipped.pixels.size() == width * height);
    }
}

TEST_CASE("text far outside or on an empty picture changes nothing") {
  CHECK(written("text", 1000000, -1000000, 5, 8, 8) == Image(8, 8, paper));
  CHECK(written("text", 0, 0, 1, 0, 0) == Image(0, 0, paper));
  CHECK(written("", 0, 0, 1, 8, 8) == Image(8, 8, paper));
}
