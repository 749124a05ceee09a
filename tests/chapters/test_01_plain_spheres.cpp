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

TEST_CASE("known pixels have the colors that paper and pencil give") {
  const Image drawn = picture(chapter_01::Lesson{});
  // The ray through the middle of an odd picture meets the middle sphere at (0, 2, 8) / sqrt(68).
  const Image odd = picture(chapter_01::Lesson{}, 1, 1);
  const double y = 2 / std::sqrt(68.0);
  const double z = 8 / std::sqrt(68.0);
  const double path = std::sqrt(25 + (5 - y) * (5 - y) + (5 - z) * (5 - z));
  const double cosine = (y * (5 - y) + z * (5 - z)) / path;
  const int expected = static_cast<int>(255 * 0.9 * (0.2 + 0.8 * cosine));
  CHECK(static_cast<int>(odd.at(0, 0).r) == expected);
  // In the shadow of the middle sphere the ground has its color times 0.2.
  CHECK(drawn.at(320, 330) == Rgb8{45, 45, 45});
  // The upper left corner is sky: 1 - t/2, 1 - 0.3 t, 1 with t from the height of the ray.
  CHECK(drawn.at(0, 0) == Rgb8{176, 208, 255});
}

TEST_CASE("all numbers draw the same picture, but for 0.03 percent of the pixels in float" *
          NeedsFloat<chapter_01::Lesson>{}) {
  check_all_numbers(chapter_01::Lesson{}, 144);
}
