// What run_chapter refuses of a lesson and of its user.
#include <doctest.h>

#include "02_checkerboard_uv/lesson.hpp"
#include "engine/run/run_chapter.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap;

namespace {

int status_of(const std::string& file) {
  const char* const arguments[] = {"stripes",  "--quiet", "--width", "8",
                                   "--height", "6",       "--out",   file.c_str()};
  return run_chapter<chapter_02::Lesson>("stripes", 8, arguments);
}

}  // namespace

TEST_CASE("a name that promises another kind of picture is refused") {
  const test::TemporaryFolder folder;
  for (const char* name : {"x.jpg", "x.jpeg", "x.gif", "x.bmp", "x.webp"})
    CHECK(status_of(folder / name) == 2);
  CHECK(folder.size() == 0);
  CHECK(status_of(folder / "jpg") == 0);
}
