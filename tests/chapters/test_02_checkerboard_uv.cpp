// Chapter 02: the daily exercise's published picture, and the step from chapter 01.
#include <doctest.h>

#include <span>

#include "01_plain_spheres/lesson.hpp"
#include "02_checkerboard_uv/lesson.hpp"
#include "support/daily_program.hpp"
#include "support/lesson_laws.hpp"
#include "support/same_picture.hpp"
#include "support/sha256.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::test;
using chapter_02::Lesson;

TEST_CASE("the picture is the daily exercise's published picture, pixel for pixel") {
  const Image drawn = picture(Lesson{});
#ifdef TEXMAP_REFERENCE_PLATFORM
  static_assert(sizeof(Rgb8) == 3);
  const std::span<const std::uint8_t> bytes(&drawn.pixels[0].r, 3 * drawn.pixels.size());
  // The hash of the 1,440,000 red, green and blue bytes that its texture_output.png holds.
  CHECK(sha256(bytes) == "9f0d68575b344f9a050be7e15b22f487245c3fece0ea1fef1c5f6d8c6df150e3");
#endif
  expect_same_picture(drawn, daily::draw(800, 600, true));
}

TEST_CASE(
    "the daily exercise's published figures hold, but for the one that was taken upside down") {
  const Image drawn = picture(Lesson{});
  const Mean middle = mean_of(drawn, 350, 250, 100, 100);
  CHECK(middle.r == doctest::Approx(83.68).epsilon(0.0001));
  CHECK(middle.g == doctest::Approx(83.68).epsilon(0.0001));
  CHECK(middle.b == doctest::Approx(129.29).epsilon(0.0001));
  const Mean red_sphere = mean_of(drawn, 180, 280, 80, 80);
  CHECK(red_sphere.r == doctest::Approx(166.19).epsilon(0.0001));
  CHECK(red_sphere.g == doctest::Approx(49.51).epsilon(0.0001));
  const Mean published = mean_of(upside_down(drawn), 180, 280, 80, 80);
  CHECK(published.r == doctest::Approx(161.13).epsilon(0.0001));
  CHECK(published.g == doctest::Approx(68.31).epsilon(0.0001));
  CHECK(mean_of(drawn, 0, 0, 800, 600).r == doctest::Approx(123.703).epsilon(0.00001));
  const auto [darkest, brightest] = std::minmax_element(drawn.pixels.begin(), drawn.pixels.end(),
                                                        [](Rgb8 a, Rgb8 b) { return a.r < b.r; });
  CHECK(static_cast<int>(darkest->r) == 10);
  CHECK(static_cast<int>(brightest->r) == 254);
}

TEST_CASE("a checkerboard with both squares in one color is a plain sphere") {
  Lesson one_color;
  one_color.checkered.texture.even = white;
  for (auto& object : one_color.objects) {
    if (std::holds_alternative<chapter_02::Checkered>(object.paint))
      object.paint = one_color.checkered;
  }
  chapter_01::Lesson plain;
  plain.objects[chapter_01::right].paint = Solid{white};
  expect_same_picture(picture(one_color), picture(plain));
}

TEST_CASE("only the three checkered objects change from chapter 01") {
  CHECK(check_step(chapter_01::Lesson{}, Lesson{}, chapter_02::left) > 5000);
}

TEST_CASE("all numbers draw the same picture, but for 0.05 percent of the pixels in float" *
          NeedsFloat<Lesson>{}) {
  check_all_numbers(Lesson{}, 240);
}
