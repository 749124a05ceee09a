// Chapter 02: seed 0's published picture, and the step from chapter 01.
#include <doctest.h>

#include <span>

#include "01_plain_spheres/lesson.hpp"
#include "02_checkerboard_uv/lesson.hpp"
#include "pictures.hpp"
#include "seed0_program.hpp"
#include "sha256.hpp"

using namespace texmap;
using chapter_02::Lesson;

TEST_CASE("the picture is seed 0's published picture, pixel for pixel") {
  const Image drawn = test::picture(Lesson{});
  static_assert(sizeof(Rgb8) == 3);
  const std::span<const std::uint8_t> bytes(&drawn.pixels[0].r, 3 * drawn.pixels.size());
#ifdef TEXMAP_REFERENCE_PLATFORM
  // The hash of the 1,440,000 red, green and blue bytes that the seed's texture_output.png holds.
  CHECK(test::sha256(bytes) == "9f0d68575b344f9a050be7e15b22f487245c3fece0ea1fef1c5f6d8c6df150e3");
#else
  MESSAGE("not the platform of the published hash: " << test::sha256(bytes));
#endif
  CHECK(test::count_different(drawn, test::seed0::draw(800, 600, true)) == 0);
}

TEST_CASE("the seed's published figures hold, but for the one that was taken upside down") {
  const Image drawn = test::picture(Lesson{});
  const test::Mean middle = test::mean_of(drawn, 350, 250, 100, 100);
  CHECK(middle.r == doctest::Approx(83.68).epsilon(0.0001));
  CHECK(middle.g == doctest::Approx(83.68).epsilon(0.0001));
  CHECK(middle.b == doctest::Approx(129.29).epsilon(0.0001));
  const test::Mean red_sphere = test::mean_of(drawn, 180, 280, 80, 80);
  CHECK(red_sphere.r == doctest::Approx(166.19).epsilon(0.0001));
  CHECK(red_sphere.g == doctest::Approx(49.51).epsilon(0.0001));
  const test::Mean published = test::mean_of(test::upside_down(drawn), 180, 280, 80, 80);
  CHECK(published.r == doctest::Approx(161.13).epsilon(0.0001));
  CHECK(published.g == doctest::Approx(68.31).epsilon(0.0001));
  CHECK(test::mean_of(drawn, 0, 0, 800, 600).r == doctest::Approx(123.703).epsilon(0.00001));
  const auto [darkest, brightest] =
      std::minmax_element(drawn.pixels.begin(), drawn.pixels.end(), [](Rgb8 a, Rgb8 b) { return a.r < b.r; });
  CHECK(static_cast<int>(darkest->r) == 10);
  CHECK(static_cast<int>(brightest->r) == 254);
}

TEST_CASE("a checkerboard with both squares in one color is a plain sphere") {
  Lesson one_color;
  one_color.checkered.texture.even = one_color.white.color;
  for (const int i : Lesson::changed_objects) one_color.objects[static_cast<std::size_t>(i)].paint = one_color.checkered;
  chapter_01::Lesson plain;
  plain.objects[chapter_01::right].paint = plain.white;
  CHECK(test::picture(one_color) == test::picture(plain));
}

TEST_CASE("only the three checkered objects change from chapter 01") {
  const chapter_01::Lesson before;
  const std::vector<int> seen = test::objects_seen(before);
  const Image first = test::picture(before);
  CHECK(test::changed_elsewhere(first, test::picture(Lesson{}), seen, Lesson::changed_objects) == 0);
  // The check can fail: a red sphere that turns blue is found, and so is a single stray pixel.
  Lesson stray;
  stray.objects[chapter_02::left].paint = stray.blue;
  CHECK(test::changed_elsewhere(first, test::picture(stray), seen, Lesson::changed_objects) > 5000);
  Image one_pixel = test::picture(Lesson{});
  one_pixel.at(10, 10).b ^= 1;
  CHECK(test::changed_elsewhere(first, one_pixel, seen, Lesson::changed_objects) == 1);
}

TEST_CASE("all five numbers draw the checkered stage, float off by less than 0.05 percent of the pixels") {
  const Image reference = test::picture<double>(Lesson{});
  CHECK(test::picture<long double>(Lesson{}) == reference);
  const Image in_float = test::picture<float>(Lesson{});
  CHECK(test::count_different(in_float, reference) <= 240);
#ifdef TEXMAP_HAVE_PACKS
  CHECK(test::picture<Pack<double>>(Lesson{}) == reference);
  CHECK(test::count_different(test::picture<Pack<float>>(Lesson{}), reference) <= 240);
#endif
}
