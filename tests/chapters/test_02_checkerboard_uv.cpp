// Chapter 02: the daily exercise's published picture, and the step from chapter 01.
#include <doctest.h>

#include "01_plain_spheres/lesson.hpp"
#include "02_checkerboard_uv/lesson.hpp"
#include "support/lesson_laws.hpp"
#include "support/sha256.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::test;
using chapter_02::Lesson;

TEST_CASE("the picture is the daily exercise's published picture, pixel for pixel") {
  const Image drawn = picture(Lesson{});
  static_assert(sizeof(Rgb8) == 3);
  // The hash of the 1,440,000 red, green and blue bytes that its texture_output.png holds.
  CHECK(sha256({&drawn.pixels[0].r, 3 * drawn.pixels.size()}) ==
        "9f0d68575b344f9a050be7e15b22f487245c3fece0ea1fef1c5f6d8c6df150e3");
}

TEST_CASE(
    "the daily exercise's published figures hold, but for the one that was taken upside down") {
  const Image drawn = picture(Lesson{});
  const auto has = [](const Mean& is, double r, double g) {
    CHECK(is.r == doctest::Approx(r).epsilon(0.0001));
    CHECK(is.g == doctest::Approx(g).epsilon(0.0001));
  };
  has(mean_of(drawn, 350, 250, 100, 100), 83.68, 83.68);
  has(mean_of(drawn, 180, 280, 80, 80), 166.19, 49.51);
  has(mean_of(upside_down(drawn), 180, 280, 80, 80), 161.13, 68.31);
  CHECK(mean_of(drawn, 0, 0, 800, 600).r == doctest::Approx(123.703).epsilon(0.00001));
}

TEST_CASE("only the three checkered objects change from chapter 01") {
  CHECK(check_step(chapter_01::Lesson{}, Lesson{}, chapter_02::left) > 5000);
}

TEST_CASE("all numbers draw the same picture, but for 0.05 percent of the pixels in float" *
          NeedsFloat<Lesson>{}) {
  check_all_numbers(Lesson{}, 240);
}
