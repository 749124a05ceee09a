// The map of differences: its scale, its legend, and that it lies where the pictures do.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/compare/difference_map.hpp"
#include "engine/picture/bitmap_font.hpp"
#include "engine/picture/codecs/image_limits.hpp"
#include "support/made_pictures.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

/// L* of a color, by the textbook way from bytes; the map goes the other way.
double lightness_of(Rgb8 color) {
  const auto light = [](std::uint8_t byte) {
    const double e = byte / 255.0;
    return e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * light(color.r) + 0.7152 * light(color.g) + 0.0722 * light(color.b);
  return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : 24389.0 / 27 * y;
}

/// Whether the text appears in the picture at or below this row, on a plain background.
bool shows(const Image& image, const std::string& text, int from_row) {
  Image word(text_width(text), letter_rows);
  draw_text(word, 0, 0, text, {1, 1, 1});
  for (int row = from_row; row + word.height <= image.height; ++row) {
    for (int column = 1; column + word.width < image.width; ++column) {
      const Rgb8 ground = image.at(column - 1, row);
      bool same = ground == image.at(column + word.width, row);  // nothing follows the text
      for (int y = 0; same && y < word.height; ++y) {
        for (int x = 0; same && x < word.width; ++x) {
          same = (image.at(column + x, row + y) != ground) == (word.at(x, y) == Rgb8{1, 1, 1});
        }
      }
      if (same) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("more difference is lighter, at every level, in the colors of the scale") {
  CHECK(difference_color(0) == Rgb8{0, 0, 0});
  double before = 20;  // one level is visible on black
  for (int levels = 1; levels < 256; ++levels) {
    const double lightness = lightness_of(difference_color(levels));
    CAPTURE(levels);
    // Rounding three bytes moves L* by at most 0.25; above 32 levels a step is smaller than that.
    CHECK(lightness > before - (levels <= 32 ? 0 : 0.25));
    before = lightness;
  }
  CHECK(difference_color(1) == Rgb8{50, 55, 85});
  CHECK(difference_color(15) == Rgb8{138, 127, 98});
  CHECK(difference_color(255) == Rgb8{255, 237, 102});
}

TEST_CASE("every pixel of the map has the color of its difference, at its place") {
  const Image a = noise(400, 50, 1);
  Image b = a;
  b.at(0, 0).r = static_cast<std::uint8_t>(a.at(0, 0).r ^ 0x80u);
  b.at(399, 49).b = static_cast<std::uint8_t>(a.at(399, 49).b ^ 1u);
  b.at(17, 30) = {static_cast<std::uint8_t>(255 - a.at(17, 30).r), a.at(17, 30).g, a.at(17, 30).b};
  const Image map = difference_map(a, b);
  CHECK(map.width == 400);
  CHECK(map.height > 50);
  for (int row = 0; row < 50; ++row) {
    for (int column = 0; column < 400; ++column) {
      const Rgb8 expected =
          difference_color(channel_difference(a.at(column, row), b.at(column, row)));
      if (map.at(column, row) != expected) FAIL_CHECK("at " << column << ", " << row);
    }
  }
  CHECK(map.at(0, 0) == difference_color(128));
}

TEST_CASE("the legend has the whole scale and its random, also below a small picture") {
  for (const int width : {1, 200, 800}) {
    CAPTURE(width);
    const Image a(width, 3, {1, 2, 3});
    const Image map = difference_map(a, a);
    for (const char* number : {"0", "1", "3", "7", "15", "31", "63", "127", "255"}) {
      CAPTURE(number);
      CHECK(shows(map, number, 3));
    }
    CHECK_FALSE(shows(map, "511", 3));
    // The bar goes from end to end of the scale, to within a step of a byte.
    for (const int levels : {3, 15, 127, 255}) {
      const auto near = [&](Rgb8 c) {
        return channel_difference(c, difference_color(levels)) <= 1;
      };
      CHECK(std::any_of(map.pixels.begin() + 3L * map.width, map.pixels.end(), near));
    }
  }
}

TEST_CASE("what the mask leaves out is hatched in greys, and the legend says so") {
  const Image a = noise(40, 40, 2);
  Image b = a;
  b.at(5, 5) = {0, 0, 0};
  Image mask(40, 40, {255, 255, 255});
  for (int row = 0; row < 10; ++row) {
    for (int column = 0; column < 10; ++column) mask.at(column, row) = {};
  }
  const Image map = difference_map(a, b, mask);
  int greys[2] = {0, 0};
  for (int row = 0; row < 10; ++row) {
    for (int column = 0; column < 10; ++column) {
      const Rgb8 c = map.at(column, row);
      CHECK(c.r == c.g);
      CHECK(c.g == c.b);
      CHECK(c.r > 0);
      ++greys[c.r > 100 ? 1 : 0];
    }
  }
  CHECK(greys[0] > 20);
  CHECK(greys[1] > 20);
  CHECK(shows(map, "left out", 40));
  CHECK_FALSE(shows(difference_map(a, b), "left out", 40));
}

TEST_CASE("as high as a file may be a map has no legend, and of other sizes there is none") {
  const Image a(2, static_cast<int>(max_image_side), {9, 9, 9});
  CHECK(difference_map(a, a).width == 2);
  CHECK(difference_map(a, a).height == a.height);
  CHECK_THROWS_AS((void)difference_map(Image(2, 3), Image(3, 2)), DifferenceError);
  CHECK_THROWS_AS((void)difference_map(Image(2, 3), Image(2, 3), Image(2, 2)), DifferenceError);
}
