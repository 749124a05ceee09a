// Chapter 01: every pixel has the scene's closed form at the ray through its center.
#include <doctest.h>

#include "01_plain_spheres/lesson.hpp"
#include "support/daily_program.hpp"
#include "support/lesson_laws.hpp"
#include "support/same_picture.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::test;

TEST_CASE(
    "every pixel has the color that an independent program computes for the ray through its "
    "center") {
  const Image drawn = picture(chapter_01::Lesson{});
  const Image expected = daily::draw(800, 600, false);
  expect_same_picture(drawn, expected);
  // The comparison can fail: the checkered scene is another picture.
  CHECK(count_different(drawn, daily::draw(800, 600, true)) > 100000);
}

TEST_CASE("all numbers draw the same picture, but for 0.03 percent of the pixels in float" *
          NeedsFloat<chapter_01::Lesson>{}) {
  check_all_numbers(chapter_01::Lesson{}, 144);
}
