// Chapter 00: one file of plain C++ draws what chapters 01 and 02 draw with the common code. It
// shares no code with them, and so is their judge: each pixel has the color that its ray sees.
#include <doctest.h>

#include "02_checkerboard_uv/lesson.hpp"
#include "support/pictures.hpp"
#include "support/running.hpp"
#include "support/same_picture.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::test;

TEST_CASE("the file draws chapter 02's picture, pixel for pixel; test_01 compares --plain") {
  const Image checkered = drawn_by(TEXMAP_CHAPTER, "");
  expect_same_picture(checkered, picture(chapter_02::Lesson{}));
  CHECK(count_different(drawn_by(TEXMAP_CHAPTER, "--plain"), checkered) > 100000);
}

TEST_CASE("an option that is not there is refused, and so is a file that cannot be written") {
  const Outcome unknown = run("\"" TEXMAP_CHAPTER "\" --help");
  CHECK(unknown.status == 2);
  CHECK(unknown.err == "usage: 00_one_file [--plain] [--out FILE.png]\n");
  const TemporaryFolder folder;
  const Outcome nowhere = run("\"" TEXMAP_CHAPTER "\" --out \"" + (folder / "") + "\"");
  CHECK(nowhere.status == 1);
  CHECK(nowhere.err.find("cannot write") != std::string::npos);
}
