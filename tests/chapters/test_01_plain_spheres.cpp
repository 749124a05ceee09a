// Chapter 01: its picture is that of a program without the common code, and all numbers draw it.
#include <doctest.h>

#include "01_plain_spheres/lesson.hpp"
#include "support/lesson_laws.hpp"
#include "support/running.hpp"
#include "support/same_picture.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::test;

#ifdef TEXMAP_ONE_FILE  // chapter 00 is there
TEST_CASE(
    "every pixel has the color that an independent program computes for the ray through its "
    "center") {
  expect_same_picture(picture(chapter_01::Lesson{}), drawn_by(TEXMAP_ONE_FILE, "--plain"));
}
#endif

TEST_CASE("all numbers draw the same picture, but for 0.03 percent of the pixels in float" *
          NeedsFloat<chapter_01::Lesson>{}) {
  check_all_numbers(chapter_01::Lesson{}, 144);
}
