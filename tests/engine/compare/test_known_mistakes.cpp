// Whole pictures with known mistakes: each gets its name; what is not sure gets none. Mistakes of
// look-ups stand in pages/test_symptoms.
#include <doctest.h>

#include <algorithm>
#include <cstdint>

#include "engine/compare/known_mistakes.hpp"
#include "engine/picture/load_image.hpp"
#include "engine/system/system.hpp"
#include "support/image_errors.hpp"
#include "support/made_pictures.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

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
Rgb8 inverted(Rgb8 p) {
  const auto inverse = [](std::uint8_t x) { return static_cast<std::uint8_t>(255 - x); };
  return {inverse(p.r), inverse(p.g), inverse(p.b)};
}

/// The picture moved, with its other side at the edge, or black.
Image moved(const Image& picture, int right, int down, bool around) {
  Image image(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const int x = column - right, y = row - down;
      if (around || (x >= 0 && x < width && y >= 0 && y < height))
        image.at(column, row) = picture.at((x + width) % width, (y + height) % height);
    }
  }
  return image;
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
      {order + ": green, blue, red", each(right,
                                          [](Rgb8 p) {
                                            return Rgb8{p.g, p.b, p.r};
                                          })},
      {order + ": blue, red, green", each(right,
                                          [](Rgb8 p) {
                                            return Rgb8{p.b, p.r, p.g};
                                          })},
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
      {"", with_noise(right, 8, 3)},
      {"", with_noise(right, 60, 3)},
      {"", noise(width, height, 5)},
      {"", ramps(width, height)},
      {"", each(right,
                [](Rgb8 p) {
                  return Rgb8{p.g, p.r, p.b};
                })},
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

TEST_CASE("two mistakes that draw the same picture are both named, and three are not") {
  const Image right = ramps(64, 48);
  const Image wrong = mirrored(right);
  const std::vector<WrongPicture> two{{"a", "a mistake", wrong}, {"b", "another: why", wrong}};
  const std::vector<WrongPicture> three{two[0], two[1], {"c", "a third", wrong}};
  const std::vector<WrongPicture> near{{"a", "a mistake", with_noise(wrong, 4, 3)},
                                       {"b", "another", with_noise(wrong, 4, 5)}};
  const std::vector<WrongPicture> alike{{"a", "a mistake", wrong}, {"b", "a mistake", wrong}};
  CHECK(name_mistake(wrong, right, two) == "a mistake or another: a mistake; or another: why");
  CHECK(name_mistake(wrong, right, three).empty());
  CHECK(name_mistake(wrong, right, near).empty());
  CHECK(name_mistake(wrong, right, alike) == "a mistake");
  // A mistake that does not show in this picture is no rival.
  CHECK(name_mistake(right, wrong, {{{"c", "another", wrong}, {"a", "a mistake", right}}}) ==
        "a mistake");
}

TEST_CASE("a right picture that was changed as a whole is named, and a wrong one is not") {
  const Image right = load_image(TEXMAP_TESTS_DIR "/golden/08_repeat.png");
  Image soft = right, small(width / 2, height / 2);  // each pixel mixed with the next; every other
  for (std::size_t i = 1; i < soft.pixels.size(); ++i) {
    const Rgb8 p = right.pixels[i - 1], q = right.pixels[i];
    const auto mean = [](int a, int b) { return static_cast<std::uint8_t>((a + b) / 2); };
    soft.pixels[i] = {mean(p.r, q.r), mean(p.g, q.g), mean(p.b, q.b)};
  }
  for (int row = 0; row < small.height; ++row)
    for (int column = 0; column < small.width; ++column)
      small.at(column, row) = right.at(2 * column, 2 * row);
  const auto with = [&](int levels) {
    Image image = right;
    for (Rgb8& p : image.pixels)
      for (auto* channel : {&p.r, &p.g, &p.b})
        *channel = static_cast<std::uint8_t>(std::clamp(*channel + levels, 0, 255));
    return image;
  };
  const std::pair<std::string, Image> rows[] = {
      {"brighter by 12 levels", with(12)},
      {"darker by 40 levels", with(-40)},
      {"", with(1)},
      {"blurred", soft},
      {"scaled", small},
      {"", right},
      {"", mirrored(right)},
      {"", mirrored(soft)},
      {"", mirrored(small)},
      {"", moved(right, 3, 0, true)},
      {"", with_noise(right, 60, 3)},
      {"", Image()},
  };
  for (const auto& row : rows) CHECK(short_words(name_change(row.second, right)) == row.first);
}

TEST_CASE("a table of mistakes that is not there or broken is an error that names it") {
  const TemporaryFolder folder;
  const auto error = [&] {
    return image_error_of([&] { (void)load_wrong_pictures(path_of(folder.path())); });
  };
  CHECK(error().find("mistakes.txt") != std::string::npos);
  write_text_atomically(path_of(folder / "mistakes.txt"), std::string("no tab\n"));
  CHECK(error().find("without a tab") != std::string::npos);
}
