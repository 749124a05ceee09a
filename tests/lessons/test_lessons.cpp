// What run_chapter refuses of a lesson and of its user.
#include <doctest.h>

#include "02_checkerboard_uv/lesson.hpp"
#include "engine/app/run_chapter.hpp"
#include "engine/app/texture_file.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap;

namespace {

/// Offers a texture, and has its hook misspelt without `override`.
struct Forgetful : chapter_02::Lesson {
  TextureFile texture{"earth.png"};
  void options(CommandLine& line) override { offer(line, texture); }
  void perpare(Session& /*session*/) {}
};

template <class Lesson = chapter_02::Lesson>
int status_of(const std::string& file) {
  const char* const arguments[] = {"stripes",  "--quiet", "--width", "8",
                                   "--height", "6",       "--out",   file.c_str()};
  return run_chapter<Lesson>("stripes", 8, arguments);
}

}  // namespace

TEST_CASE("a texture that is offered and never loaded is an error, not a picture without it") {
  const test::TemporaryFolder folder;
  CHECK(status_of<Forgetful>(folder / "x.png") == 1);
  CHECK(folder.size() == 0);
  CHECK(status_of(folder / "x.png") == 0);
}

TEST_CASE("a name that promises another kind of picture is refused") {
  const test::TemporaryFolder folder;
  for (const char* name : {"x.jpg", "x.jpeg", "x.gif", "x.bmp", "x.webp"})
    CHECK(status_of(folder / name) == 2);
  CHECK(folder.size() == 0);
  CHECK(status_of(folder / "jpg") == 0);
}
