// Chapter 05: rotation about the vertical axis.
#include <doctest.h>

#include "03_image_texture/lesson.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "support/lesson_laws.hpp"
#include "support/same_picture.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::test;
using chapter_05::Lesson;

namespace {

Lesson turned(const std::string& degrees, const std::string& convention = "rtiow") {
  return prepared<Lesson>({"--degrees", degrees, "--convention", convention});
}

}  // namespace

TEST_CASE(
    "at 0 and at 360 degrees the picture is chapter 03's, and so it is after a million turns") {
  const Image before = picture(prepared<chapter_03::Lesson>());
  for (const char* degrees : {"0", "360", "-360", "360e6"}) {
    CAPTURE(degrees);
    expect_same_picture(picture(turned(degrees)), before);
  }
  CHECK(count_different(picture(turned("1")), before) > 1000);
}

TEST_CASE("1e9 degrees are 280 degrees, and -80 are too") {
  const Image expected = picture(turned("280"));
  expect_same_picture(picture(turned("1e9")), expected);
  expect_same_picture(picture(turned("-80")), expected);
  CHECK(count_different(picture(turned("281")), expected) > 1000);
}

TEST_CASE(
    "a quarter turn makes the lecture's convention the book's, but for pixels on the edge of a "
    "texel") {
  const Image book = picture(turned("0", "rtiow"));
  expect_same_picture(picture(turned("90", "lecture")), book, {.pixels = 4});
  CHECK(count_different(picture(turned("270", "lecture")), book) > 3000);
}

TEST_CASE("only the middle sphere changes from chapter 04") {
  CHECK(check_step(prepared<chapter_04::Lesson>(), turned("90"), chapter_05::ground) > 3000);
}

TEST_CASE("rotating the globe moves its map by degrees / 360 of its width") {
  // A map of 360 columns has one column a degree: turning by 30 degrees is shifting by 30 columns.
  Image stripes(360, 1);
  for (int column = 0; column < 360; ++column)
    stripes.at(column, 0) = {static_cast<std::uint8_t>(column % 256), 0, 0};
  Image shifted = stripes;
  for (int column = 0; column < 360; ++column)
    shifted.at(column, 0) = stripes.at((column + 30) % 360, 0);
  const auto with = [](const Image& map, double degrees) {
    Lesson lesson;
    lesson.objects[chapter_05::middle].paint =
        chapter_05::Textured{{rotation_y(degrees), {}}, {map}};
    return picture(lesson);
  };
  expect_same_picture(with(stripes, 30), with(shifted, 0), {.pixels = 4});
  CHECK(count_different(with(stripes, 30), with(stripes, 0)) > 5000);
}
