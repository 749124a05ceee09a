// Chapter 05: rotation about the vertical axis.
#include <doctest.h>

#include <string>
#include <vector>

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

TEST_CASE("whole turns are none, a million of them too, and any number of degrees is an angle") {
  const Image before = picture(prepared<chapter_03::Lesson>());
  for (const char* degrees : {"0", "-360", "360e6"}) {
    CAPTURE(degrees);
    expect_same_picture(picture(turned(degrees)), before);
  }
  CHECK(count_different(picture(turned("1")), before) > 1000);
  expect_same_picture(picture(turned("1e9")), picture(turned("-80")));
}

TEST_CASE(
    "a quarter turn makes the lecture's convention the book's, but for pixels on the edge of a "
    "texel") {
  const Image book = picture(turned("0", "rtiow"));
  expect_same_picture(picture(turned("90", "lecture")), book, {.pixels = 4});
  CHECK(count_different(picture(turned("270", "lecture")), book) > 3000);
}

TEST_CASE("a quarter turn adds 1/4 to u, as chapter 04's --uv-offset does") {
  expect_same_picture(picture(prepared<chapter_04::Lesson>({"--uv-offset", "0.25,0"})),
                      picture(turned("90")), {.pixels = 4});
}

TEST_CASE("only the middle sphere changes from chapter 04") {
  CHECK(check_step(prepared<chapter_04::Lesson>(), turned("90"), chapter_05::ground) > 3000);
}

TEST_CASE("without a turn each layout is that of chapter 04") {
  for (const std::vector<std::string>& layout :
       {std::vector<std::string>{"--convention", "daily"}, {"--rounding", "lecture"}}) {
    std::vector<std::string> options = layout;
    options.insert(options.end(), {"--degrees", "0"});
    expect_same_picture(picture(prepared<Lesson>(options)),
                        picture(prepared<chapter_04::Lesson>(layout)));
  }
}
