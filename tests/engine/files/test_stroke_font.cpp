// Writing on pictures.
#include <doctest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "engine/files/stroke_font.hpp"

using namespace texmap;

namespace {

constexpr Rgb8 paper{10, 20, 30}, ink{210, 100, 50};

Image written(const std::string& text, int column, int row, int size, int width, int height) {
  Image image(width, height, paper);
  draw_text(image, column, row, text, ink, size);
  return image;
}

/// The sum of how much ink two pictures' pixels differ in, or a part of them.
double difference(const Image& a, const Image& b, int from = 0) {
  double sum = 0;
  for (int row = 0; row < a.height; ++row)
    for (int x = from; x < a.width; ++x) sum += std::abs(a.at(x, row).r - b.at(x, row).r) / 200.0;
  return sum;
}

}  // namespace

TEST_CASE("every character has its own shape, its ink within its width, and space beside it") {
  std::map<std::string, Image> shapes;
  for (const char* other : {"°", "×", "←", "↑", "→", "↓", "box, for é"}) shapes[other];
  for (char c = ' '; c <= '~'; ++c) shapes[std::string(1, c)];
  const Image empty(16, 16, paper);
  for (auto& [key, shape] : shapes) {
    const std::string character = key.size() > 3 ? "é" : key;
    CAPTURE(character);
    shape = written(character, 2, 2, 11, 16, 16);
    CHECK((difference(shape, empty) > 0.9) == (character != " "));
    CHECK(difference(shape, empty, 3 + text_width(character)) == 0);
    for (const auto& before : shapes) {
      const std::string& other = before.first;
      if (other == key) break;
      CAPTURE(other);
      CHECK(difference(shape, before.second) > 0.9);
      if (other.size() < 4)
        CHECK(text_width(character + other) > text_width(character) + text_width(other));
    }
  }
  CHECK(text_width("") == 0);
  CHECK(text_width("H", 22) == 12);
  CHECK(written("\xff", 2, 2, 11, 16, 16) == written("é", 2, 2, 11, 16, 16));
}

TEST_CASE("a stroke has the ink of a line with round ends, at every size") {
  for (const int size : {22, 33, 110}) {
    const double unit = size / 11.0;  // the minus is two of them long, the pen 1.1 wide
    const Image empty(3 * size, 3 * size, paper);
    CHECK(difference(written("-", size, size, size, 3 * size, 3 * size), empty) ==
          doctest::Approx((2.2 + std::numbers::pi * 0.3025) * unit * unit).epsilon(0.02));
  }
  CHECK(written("-", 0, -4, 11, 3, 1) == Image(3, 1, ink));
}

TEST_CASE("across or beyond an edge a text is the part of it that lies inside") {
  const Image whole = written("O#W°", 60, 60, 22, 180, 140);
  for (int row = -30; row <= 20; row += 3) {
    for (int column = -60; column <= 30; column += 5) {
      const Image part =
          image_of(23, 13, [&](int x, int y) { return whole.at(x - column + 60, y - row + 60); });
      REQUIRE(written("O#W°", column, row, 22, 23, 13) == part);
    }
  }
  for (int x = 0; x < 14; ++x)
    CHECK(whole.at(60 + x, 62) == whole.at(73 - x, 62));  // the O's curves
  CHECK(written("text", 1000000, -1000000, 55, 8, 8) == Image(8, 8, paper));
}
