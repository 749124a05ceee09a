// Chapter 05: rotation about the vertical axis.
#include <doctest.h>

#include "03_image_texture/lesson.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "pictures.hpp"

using namespace texmap;
using chapter_05::Lesson;

namespace {

Lesson turned(const std::string& degrees, const std::string& convention = "rtiow") {
  return test::prepared<Lesson>({"--degrees", degrees, "--convention", convention});
}

}  // namespace

TEST_CASE("at 0 and at 360 degrees the picture is chapter 03's, and so it is after a million turns") {
  const Image before = test::picture(test::prepared<chapter_03::Lesson>());
  for (const char* degrees : {"0", "360", "-360", "360e6"}) {
    CAPTURE(degrees);
    CHECK(test::picture(turned(degrees)) == before);
  }
  CHECK(test::count_different(test::picture(turned("1")), before) > 1000);
}

TEST_CASE("1e9 degrees are 280 degrees, and -80 are too") {
  const Image expected = test::picture(turned("280"));
  CHECK(test::picture(turned("1e9")) == expected);
  CHECK(test::picture(turned("-80")) == expected);
  CHECK(test::count_different(test::picture(turned("281")), expected) > 1000);
}

TEST_CASE("a quarter turn makes the lecture's convention the book's, but for pixels on the edge of a texel") {
  const Image book = test::picture(turned("0", "rtiow"));
  CHECK(test::count_different(test::picture(turned("90", "lecture")), book) <= 4);
  CHECK(test::count_different(test::picture(turned("270", "lecture")), book) > 3000);
}

TEST_CASE("only the middle sphere changes from chapter 04") {
  const chapter_04::Lesson before = test::prepared<chapter_04::Lesson>();
  const std::vector<int> seen = test::objects_seen(before);
  const Image first = test::picture(before);
  const Lesson after = turned("90");
  CHECK(test::changed_elsewhere(first, test::picture(after), seen, Lesson::changed_objects) == 0);
  Lesson stray = after;
  stray.objects[chapter_05::ground].paint = stray.blue;
  CHECK(test::changed_elsewhere(first, test::picture(stray), seen, Lesson::changed_objects) > 10000);
}

TEST_CASE("rotating the globe moves its map by degrees / 360 of its width") {
  // On a map of 360 columns, one degree is one column: 30 degrees show what a map shifted by 30 columns shows.
  Image stripes(360, 1);
  for (int column = 0; column < 360; ++column) stripes.at(column, 0) = {static_cast<std::uint8_t>(column % 256), 0, 0};
  Image shifted = stripes;
  for (int column = 0; column < 360; ++column) shifted.at(column, 0) = stripes.at((column + 30) % 360, 0);
  const auto with = [](const Image& map, double degrees) {
    Lesson lesson;
    lesson.objects[chapter_05::middle].paint = chapter_05::Textured{{rotation_y(degrees), {}}, {map}};
    return test::picture(lesson);
  };
  CHECK(test::count_different(with(stripes, 30), with(shifted, 0)) <= 4);
  CHECK(test::count_different(with(stripes, 30), with(stripes, 0)) > 5000);
}
