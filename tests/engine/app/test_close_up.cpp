// Close-ups, as --zoom and --at draw them in every chapter with a camera; and what they and --show
// refuse.
#include "engine/render/close_up.hpp"

#include <doctest.h>

#include <filesystem>

#include "02_checkerboard_uv/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "07_earth_by_sampling/lesson.hpp"
#include "08_triangle_uv/lesson.hpp"
#include "09_texture_filtering/lesson.hpp"
#include "11_bump_and_normal_maps/lesson.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

/// The lesson's picture as its program draws it with these words.
template <class Lesson>
Image drawn(const std::vector<std::string>& words, int width, int height) {
  Lesson lesson;
  CommandLine line("test", "");
  lesson.options(line);
  Session session("test", line, Lesson::about, offers_for(lesson));
  REQUIRE(line.parse(words));
  session.settings.quiet = true;
  session.settings.samples = 1;
  lesson.prepare(session);
  return session.draw(lesson, width, height);
}

Image crop(const Image& image, int left, int top, int width, int height) {
  Image part(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column)
      part.at(column, row) = image.at(left + column, top + row);
  }
  return part;
}

/// What a program says that refuses these words and writes no file; empty if it draws.
template <class Lesson>
std::string complaint(std::vector<std::string> words) {
  const TemporaryFolder folder;
  const std::string file = folder / "picture.png";
  words.insert(words.end(), {"--quiet", "--width", "40", "--height", "30", "--out", file});
  Lesson lesson;
  CommandLine line("test", "");
  lesson.options(line);
  Session session("test", line, Lesson::about, offers_for(lesson));
  try {
    if (line.parse(words)) draw_and_save(session, lesson);
  } catch (const UsageError& error) {
    CHECK_FALSE(std::filesystem::exists(file));
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("twice as large is the middle of the picture of twice the size, to the byte") {
  const auto check = [](auto lesson, int width, int height, std::vector<std::string> words = {}) {
    using Lesson = decltype(lesson);
    CAPTURE(Lesson::about.idea);
    const Image large = drawn<Lesson>(words, 2 * width, 2 * height);
    words.insert(words.end(), {"--zoom", "2"});
    const Image close = drawn<Lesson>(words, width, height);
    CHECK(close == crop(large, width / 2, height / 2, width, height));
    CHECK(count_different(close, crop(large, width / 2 + 1, height / 2, width, height)) > 50);
  };
  check(chapter_02::Lesson{}, 160, 120);
  check(chapter_05::Lesson{}, 160, 120);
  check(chapter_05::Lesson{}, 160, 120, {"--show", "uv"});
  check(chapter_07::Lesson{}, 80, 60, {"--show", "normal"});
  check(chapter_08::Lesson{}, 80, 60);
  check(chapter_09::Lesson{}, 160, 120, {"--filter", "trilinear"});  // footprints are halved, too
}

TEST_CASE("three times as large each pixel becomes 3 x 3, itself in their middle, in any size") {
  const auto check = [](int width, int height, int column, int row) {
    CAPTURE(width);
    CAPTURE(column);
    const Image whole = drawn<chapter_05::Lesson>({}, width, height);
    const std::string at = std::to_string(column) + ',' + std::to_string(row);
    const Image close = drawn<chapter_05::Lesson>({"--zoom", "3", "--at", at}, width, height);
    long same = 0, other = 0;
    for (int y = row % 3; y < height; y += 3) {
      for (int x = column % 3; x < width; x += 3) {
        const Rgb8 expected = whole.at(column + (x - column) / 3, row + (y - row) / 3);
        (close.at(x, y) == expected ? same : other) += 1;
      }
    }
    CHECK(other == 0);
    CHECK(same >= long{width / 3} * (height / 3));
  };
  check(160, 120, 83, 61);
  check(161, 121, 80, 60);
  check(160, 120, 0, 0);
  check(160, 120, 159, 119);
  // Of an odd size the middle pixel stays unless another is named.
  CHECK(drawn<chapter_05::Lesson>({"--zoom", "3"}, 161, 121) ==
        drawn<chapter_05::Lesson>({"--zoom", "3", "--at", "80,60"}, 161, 121));
}

TEST_CASE("what --zoom and --at cannot take is refused, and no file is written") {
  for (const char* const wrong : {"0", "nan", "0.009", "1000001", ""}) {
    CAPTURE(wrong);
    CHECK(complaint<chapter_02::Lesson>({"--zoom", wrong}) ==
          "--zoom takes a number from 0.01 to 1e+06, not '" + std::string(wrong) + "'");
  }
  const std::string column = "the column of --at takes a whole number from 0 to 39, not ";
  const std::string row = "the row of --at takes a whole number from 0 to 29, not ";
  for (const auto& [place, says] : std::vector<std::pair<const char*, std::string>>{
           {"20", "--at takes COLUMN,ROW such as 400,300, not '20'"},
           {"40,0", column + "'40'"},
           {"0,30", row + "'30'"},
           {"1,2,3", row + "'2,3'"},
           {",", column + "''"},
           {"39,29", ""}}) {
    CHECK(complaint<chapter_02::Lesson>({"--zoom", "2", "--at", place}) == says);
  }
  CHECK(complaint<chapter_02::Lesson>({"--at", "1,2"}).ends_with("give --zoom, too"));
  CHECK(complaint<chapter_11::Lesson>({"--zoom", "2", "--show", "daily"})
            .ends_with("this picture has no camera"));
  CHECK(complaint<chapter_07::Lesson>({"--zoom", "2", "--samples", "2"}).empty());
}

TEST_CASE("what --show cannot draw is refused, and no file is written") {
  CHECK(complaint<chapter_02::Lesson>({"--show", "normal", "--samples", "4"})
            .ends_with("leave --samples out"));
  CHECK(complaint<chapter_11::Lesson>({"--show", "daily", "--show", "uv"})
            .ends_with("this picture has no camera"));
  CHECK(complaint<chapter_07::Lesson>({"--show", "uv"}).empty());
}
