// Chapter 01: all numbers draw it. That its pixels are right, test_00_one_file compares.
#include <doctest.h>

#include "01_plain_spheres/lesson.hpp"
#include "support/lesson_laws.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::test;

TEST_CASE("all numbers draw the same picture, but for 0.03 percent of the pixels in float" *
          NeedsFloat<chapter_01::Lesson>{}) {
  check_all_numbers(chapter_01::Lesson{}, 144);
}
