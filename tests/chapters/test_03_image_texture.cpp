// Chapter 03: an image as a texture, and the step from chapter 02.
#include <doctest.h>

#include "02_checkerboard_uv/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "image_error.hpp"
#include "pictures.hpp"

using namespace texmap;
using chapter_03::Lesson;

namespace {

Lesson with_image(const Image& image) {
  Lesson lesson;
  lesson.objects[chapter_03::middle].paint = chapter_03::Textured{{}, {image}};
  return lesson;
}

}  // namespace

TEST_CASE("an image of one pixel is a plain sphere of its color") {
  Lesson plain;
  plain.objects[chapter_03::middle].paint = Solid{{200.0 / 255, 100.0 / 255, 50.0 / 255}};
  CHECK(test::picture(with_image(Image(1, 1, {200, 100, 50}))) == test::picture(plain));
  CHECK(test::picture(with_image(Image(1, 1, {200, 100, 51}))) != test::picture(plain));
}

TEST_CASE("an image of the checkerboard draws chapter 02 within half a texel") {
  // 0.2 and 0.8 are whole bytes, 51 and 204; v = 0 is the bottom row.
  const Rgb8 even{51, 51, 204};
  const Rgb8 odd{204, 204, 204};
  Image board(1000, 1000);
  for (int row = 0; row < 1000; ++row) {
    for (int column = 0; column < 1000; ++column)
      board.at(column, row) = (column / 100 + (999 - row) / 100) % 2 == 0 ? even : odd;
  }
  chapter_02::Lesson checkered;
  checkered.objects[chapter_02::middle].paint =
      chapter_02::Checkered{{}, {.even = {0.2, 0.2, 0.8}, .odd = {0.8, 0.8, 0.8}, .squares = 10}};
  const Image expected = test::picture(checkered);
  CHECK(test::picture(with_image(board)) == expected);
  // The test sees one texel: the board moved by one column is another picture.
  Image moved = board;
  for (int row = 0; row < 1000; ++row) {
    for (int column = 0; column < 1000; ++column) moved.at(column, row) = board.at((column + 1) % 1000, row);
  }
  CHECK(test::count_different(test::picture(with_image(moved)), expected) > 0);
}

TEST_CASE("only the middle sphere changes from chapter 02") {
  const chapter_02::Lesson before;
  const std::vector<int> seen = test::objects_seen(before);
  const Image first = test::picture(before);
  const Lesson lesson = test::prepared<Lesson>();
  const Image second = test::picture(lesson);
  CHECK(test::changed_elsewhere(first, second, seen, Lesson::changed_objects) == 0);
  CHECK(test::count_different(first, second) > 9000);
  Lesson stray = lesson;
  stray.objects[chapter_03::right].paint = stray.blue;
  CHECK(test::changed_elsewhere(first, test::picture(stray), seen, Lesson::changed_objects) > 1000);
}

TEST_CASE("a missing texture is an error that names it, never a color") {
  CHECK_THROWS_WITH_AS((void)test::prepared<Lesson>({"--texture", "no_such_picture.png"}),
                       doctest::Contains("cannot load texture 'no_such_picture.png'"), ImageError);
}

TEST_CASE("all five numbers draw the Earth alike, float off by less than 0.1 percent of the pixels") {
  const Lesson lesson = test::prepared<Lesson>();
  const Image reference = test::picture<double>(lesson);
  CHECK(test::picture<long double>(lesson) == reference);
  CHECK(test::count_different(test::picture<float>(lesson), reference) <= 480);
#ifdef TEXMAP_HAVE_PACKS
  CHECK(test::picture<Pack<double>>(lesson) == reference);
  CHECK(test::count_different(test::picture<Pack<float>>(lesson), reference) <= 480);
#endif
}
