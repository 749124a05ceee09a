// Whole pictures with known mistakes: each gets its name; what is not sure gets none. Mistakes of
// look-ups stand in pages/test_symptoms.
#include <doctest.h>

#include <algorithm>
#include <cstdint>

#include "engine/compare/known_mistakes.hpp"
#include "engine/files/load_image.hpp"
#include "support/made_pictures.hpp"
#include "support/pictures.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

constexpr int width = 240, height = 180;

/// Each pixel changed.
Image each(Image image, Rgb8 (*change)(Rgb8)) {
  for (Rgb8& pixel : image.pixels) pixel = change(pixel);
  return image;
}
Rgb8 bgr(Rgb8 p) { return {p.b, p.g, p.r}; }
Rgb8 gbr(Rgb8 p) { return {p.g, p.b, p.r}; }
Rgb8 brg(Rgb8 p) { return {p.b, p.r, p.g}; }
Rgb8 grb(Rgb8 p) { return {p.g, p.r, p.b}; }
Rgb8 inverted(Rgb8 p) {
  const auto inverse = [](std::uint8_t x) { return static_cast<std::uint8_t>(255 - x); };
  return {inverse(p.r), inverse(p.g), inverse(p.b)};
}

/// The picture moved, with its other side at the edge, or black.
Image moved(const Image& picture, int right, int down, bool around) {
  return image_of(width, height, [&](int column, int row) {
    const int x = column - right, y = row - down;
    const bool inside = x >= 0 && x < width && y >= 0 && y < height;
    return around || inside ? picture.at((x + width) % width, (y + height) % height) : Rgb8{};
  });
}

}  // namespace

TEST_CASE("a whole picture with its channels, its colors or its place wrong is named") {
  const Image right = load_image(TEXMAP_TESTS_DIR "/golden/08_repeat.png");
  const std::vector<WrongPicture> wrong = mistakes_of_the_whole(right);
  Image stray = right;
  stray.at(100, 90) = {255, 0, 255};
  const std::string order = "the channels of the whole picture are in the wrong order";
  const std::string red_and_blue = "red and blue are exchanged";
  std::vector<std::pair<std::string, Image>> rows = {
      {order + ": green, blue, red", each(right, gbr)},
      {order + ": blue, red, green", each(right, brg)},
      {"the whole picture is mirrored: columns run the other way", mirrored(right)},
      {"the whole picture is upside down: rows run the other way", upside_down(right)},
      {"the whole picture is mirrored, and " + red_and_blue, each(mirrored(right), bgr)},
      {"the whole picture is upside down, and " + red_and_blue, each(upside_down(right), bgr)},
      {"inverted: each channel is 255 minus what it should be", each(right, inverted)},
      {"white: every channel of every pixel is 255", Image(width, height, {255, 255, 255})},
      {"black: nothing was drawn", Image(width, height)},
      // Right, almost right, and nothing of these.
      {"", right},
      {"", stray},
      {"", with_noise(right, 1, 3)},
      {"", with_noise(right, 60, 3)},
      {"", noise(width, height, 5)},
      {"", ramps(width, height)},
      {"", each(right, grb)},
      {"", Image(width, height, {200, 200, 200})},
      {"", Image(width, height, {120, 160, 220})},
      {"", Image(width + 1, height)},
  };
  for (const bool around : {true, false}) {
    const std::string off = "the whole picture is one pixel ";
    rows.emplace_back(off + "too far to the right", moved(right, 1, 0, around));
    rows.emplace_back(off + "too far to the left", moved(right, -1, 0, around));
    rows.emplace_back(off + "too low", moved(right, 0, 1, around));
    rows.emplace_back(off + "too high", moved(right, 0, -1, around));
    rows.emplace_back(off + "off, in columns and in rows", moved(right, 1, -1, around));
    rows.emplace_back("", moved(right, 2, 0, around));
    rows.emplace_back("", moved(right, 0, 3, around));
  }
  for (const auto& row : rows) CHECK(name_mistake(row.second, right, wrong) == row.first);
  CHECK(name_mistake(Image(), Image(), {}).empty());
}

TEST_CASE("what went through a curve, or is softer or rougher, has its words") {
  const Image right = load_image(TEXMAP_TESTS_DIR "/golden/08_repeat.png");
  const auto level = [](double x) { return static_cast<std::uint8_t>(std::clamp(x, 0.0, 255.0)); };
  const auto through = [&](const auto& curve) {
    Image image = right;
    for (Rgb8& p : image.pixels) p = {level(curve(p.r)), level(curve(p.g)), level(curve(p.b))};
    return name_mistake(image, right, {});
  };
  CHECK(through([](int x) { return x + 20.0; }) == "brighter: every channel is 20 levels off");
  CHECK(through([](int x) { return x - 7.0; }) == "darker: every channel is 7 levels off");
  CHECK(through([](int x) { return x * 1.2; }) ==
        "brighter: every channel is 1.20 times what it should be");
  CHECK(through([](int x) { return x * x / 255.0; }) ==
        "darker: the levels went through another curve");
  CHECK(through([](int x) { return 1.3 * x - 38; }) ==
        "of another contrast: the levels went through another curve");
  CHECK(through([](int x) { return (x * 37) % 256 * 1.0; }).empty());
  CHECK(name_mistake(with_noise(right, 8, 3), right, {}).starts_with("rougher"));
  Image soft = right;
  for (int row = 1; row < height; ++row) {
    for (int column = 1; column < width; ++column) {
      const Rgb8 p = right.at(column, row), q = right.at(column - 1, row - 1);
      soft.at(column, row) = {level((p.r + q.r) / 2), level((p.g + q.g) / 2),
                              level((p.b + q.b) / 2)};
    }
  }
  CHECK(name_mistake(soft, right, {}).starts_with("softer"));
}

TEST_CASE("a wrong picture that is near to a known one, but not that one, is not named") {
  // A lamp at the other side is nearer to a mirrored picture than to the right one.
  const Image right = ramps(64, 48);
  Image near_it = mirrored(right);
  for (int row = 0; row < 12; ++row)
    for (int column = 0; column < 32; ++column) near_it.at(column, row) = right.at(column, row);
  CHECK(name_mistake(near_it, right, {{{"a", "mirrored", mirrored(right)}}}).empty());
}

TEST_CASE("two mistakes that draw the same picture are both named") {
  const Image right = ramps(64, 48);
  const Image wrong = mirrored(right);
  const std::vector<WrongPicture> two{{"a", "a mistake", wrong}, {"b", "another: why", wrong}};
  const std::vector<WrongPicture> alike{{"a", "a mistake", wrong}, {"b", "a mistake", wrong}};
  CHECK(name_mistake(wrong, right, two) == "a mistake; or another: why");
  CHECK(short_words(name_mistake(wrong, right, two)) == "a mistake or another");
  CHECK(short_words("a: b; and c: d; or e") == "a and c or e");
  CHECK(name_mistake(wrong, right, alike) == "a mistake");
  // A mistake that does not show in this picture is no rival.
  CHECK(name_mistake(right, wrong, {{{"c", "another", wrong}, {"a", "a mistake", right}}}) ==
        "a mistake");
}
