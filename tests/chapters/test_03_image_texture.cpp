// Chapter 03: an image as a texture, and the step from chapter 02.
#include <doctest.h>

#include "02_checkerboard_uv/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "support/lesson_laws.hpp"
#include "support/same_picture.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::test;
using chapter_03::Lesson;

namespace {

Lesson with_image(const Image& image) {
  Lesson lesson;
  lesson.objects[chapter_03::middle].paint = chapter_03::Textured{{}, {image}};
  return lesson;
}

}  // namespace

TEST_CASE("an image of the checkerboard draws chapter 02 within half a texel") {
  // 0.2 and 0.8 are whole bytes, 51 and 204; v = 0 is the bottom row.
  const Rgb8 even{51, 51, 204};
  const Rgb8 odd{204, 204, 204};
  const Image board = image_of(1000, 1000, [&](int column, int row) {
    return (column / 100 + (999 - row) / 100) % 2 == 0 ? even : odd;
  });
  chapter_02::Lesson checkered;
  checkered.objects[chapter_02::middle].paint =
      chapter_02::Checkered{{}, {.even = {0.2, 0.2, 0.8}, .odd = {0.8, 0.8, 0.8}, .squares = 10}};
  const Image expected = picture(checkered);
  expect_same_picture(picture(with_image(board)), expected);
  CHECK(count_different(picture(with_image(mirrored(board))), expected) > 0);
}

TEST_CASE("only the middle sphere changes from chapter 02") {
  CHECK(check_step(chapter_02::Lesson{}, prepared<Lesson>(), chapter_03::right) > 9000);
}

TEST_CASE("all numbers draw the same Earth, but for 0.1 percent of the pixels in float" *
          NeedsFloat<Lesson>{}) {
  check_all_numbers(prepared<Lesson>(), 480);
}
