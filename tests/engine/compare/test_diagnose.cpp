// ./course diagnose: which chapter's picture it is, what is wrong with it, and where that is
// explained.
#include <doctest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "engine/compare/known_mistakes.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"
#include "support/made_pictures.hpp"
#include "support/pictures.hpp"
#include "support/running.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

const Image first = ramps(80, 60), third = ramps(80, 60, 5), other = ramps(40, 60);

/// A small course with some chapters, and with pictures of wrong programs.
struct Course {
  TemporaryFolder folder;

  Course() {
    for (const char* part : {"chapters/01_a", "chapters/03_b", "chapters/04_c", "chapters/07_d",
                             "tests/golden", "docs", "out"})
      std::filesystem::create_directories(std::filesystem::path(folder / part));
    save_png(first, folder / "tests/golden/01_a.png");
    save_png(third, folder / "tests/golden/03_b.png");
    save_png(other, folder / "tests/golden/07_d.png");
    std::filesystem::copy_file(TEXMAP_TESTS_DIR "/../docs/symptoms.md",
                               std::filesystem::path(folder / "docs/symptoms.md"));
  }
  void know(const std::string& chapter, const std::vector<WrongPicture>& wrong) const {
    save_wrong_pictures(wrong, path_of(folder / ("build/learn/mistakes/" + chapter)));
  }
  [[nodiscard]] Outcome say(const std::string& words) const {
    return run("cd \"" + folder.path() + "\" && \"" TEXMAP_DIAGNOSE "\" --source chapters " +
               words);
  }
};

}  // namespace

TEST_CASE("a picture gets its chapter, its mistake and the pages, and what is none the remedy") {
  const Course course;
  const Image wrong = with_noise(third, 90, 7);
  course.know("01_a", {{"gone", "the ground is missing", noise(80, 60, 9)}});
  course.know("03_b", {{"mirrored", "mirrored: u runs the other way", wrong}});
  save_png(with_noise(third, 1, 5), course.folder / "right.png");
  save_png(with_noise(wrong, 1, 3), course.folder / "wrong.png");
  save_png(mirrored(first), course.folder / "whole.png");
  save_png(noise(80, 60, 1), course.folder / "noise.png");
  save_png(ramps(30, 30), course.folder / "small.png");
  save_png(noise(40, 60, 1), course.folder / "seven.png");
  write_text_atomically(path_of(course.folder / "text.png"), "no picture");
  write_text_atomically(path_of(course.folder / "out/04_c.html"), "the book");
  std::filesystem::copy_file(TEXMAP_TESTS_DIR "/corpus/jpg_420.jpg",
                             std::filesystem::path(course.folder / "photo.png"));
  const struct {
    const char* words;
    int status;
    const char* said;  // parts with | between them
  } rows[] = {
      {"right.png", 0, "right.png: right, a picture of chapter 03\n"},
      {"right.png --chapter 3", 0, "right.png: right"},
      {"right.png --chapter 01", 1, "not chapter 01's, but a picture of chapter 03\n"},
      {"right.png --chapter 07", 1, "not chapter 07's, but a picture of chapter 03\n"},
      {"wrong.png --undrawn asked", 1,
       "wrong.png: wrong. Chapter 03's picture, mirrored: u runs the other way\n|change      `u = "
       "1 "
       "- u`, or|out/symptoms.html#mirrored|docs/symptoms.md (./course|chapter 04: "
       "out/04_c.html\n|file://|/out/04_c.html\n|--chapter NN\n"},
      {"whole.png", 1, "Chapter 01's picture, the whole picture is mirrored|out/01_a.html"},
      {"noise.png", 1, "noise.png: wrong, by a mistake that is not known|./course diff noise"},
      {"seven.png --undrawn asked", 1, ""},
      {"small.png", 2,
       "'small.png' has 30 x 30 pixels: draw it as large as its chapter does|01: 80 x 60, 03: 80 x "
       "60, 07: 40 x 60."},
      {"noise.png --chapter 07", 2, "--height. 07: 40 x 60."},
      {"noise.png --chapter 77", 2, "there is no picture of a chapter '77'"},
      {"photo.png", 2, "'photo.png': it is a JPEG, which has other colors: name the PNG"},
      {"text.png", 2, "'text.png': it is no PNG"},
      {"none.png", 2, "'none.png'"},
      {"", 2, "FILE"},
  };
  for (const auto& row : rows) {
    CAPTURE(row.words);
    const Outcome outcome = course.say(row.words);
    CHECK(outcome.status == row.status);
    std::istringstream parts(row.said);
    for (std::string part; std::getline(parts, part, '|');)
      CHECK_MESSAGE(has(outcome.out + outcome.err, part), part, ": ", outcome.out, outcome.err);
  }
  CHECK(text_in(course.folder / "asked") == "07_d");
  // What a reader's wrong lesson drew is not taken.
  save_png(wrong, course.folder / "build/learn/mistakes/03_b/right.png");
  CHECK(course.say("wrong.png --undrawn asked").status == 1);
  CHECK(text_in(course.folder / "asked") == "03_b");
  CHECK(has(course.say("wrong.png").out, "a mistake that is not known"));
}

TEST_CASE("what is painted over a part of a picture does not make another chapter's nearer") {
  const Course course;
  for (const Rgb8 paint : {Rgb8{255, 0, 0}, Rgb8{255, 255, 255}, Rgb8{0, 0, 0}}) {
    const auto painted = [&](int x, int y) { return x < 40 && y < 40 ? paint : third.at(x, y); };
    save_png(image_of(80, 60, painted), course.folder / "my.png");
    CHECK(has(course.say("my.png").out, "The nearest picture is 03's:\n"));
  }
}

TEST_CASE("a right picture with a few wrong pixels is said to be that, with the place of one") {
  const Course course;
  const struct {
    Rgb8 dot;
    const char* words;
  } rows[] = {
      {{0, 0, 0}, "4 pixels: black dots"},
      {{255, 255, 255}, "4 pixels: white dots"},
      {{9, 200, 90}, "4 pixels: pixels of other colors"},
  };
  for (const auto& row : rows) {
    Image damaged = third;
    for (const int column : {10, 30, 50, 70}) damaged.at(column, 20) = row.dot;
    save_png(damaged, course.folder / "my.png");
    const Outcome outcome = course.say("my.png");
    CHECK(outcome.status == 1);
    CHECK_MESSAGE(has(outcome.out, std::string("chapter 03's picture, right but for ") + row.words),
                  outcome.out);
    CHECK(has(outcome.out, "the first   column 10, row 20\n"));
  }
  // A file's name says which chapter it is; a number behind other letters is not a chapter's.
  for (const auto& [name, chapter] : {std::pair{"noise.png", "01"},
                                      {"my_03.png", "03"},
                                      {"ch03.png", "03"},
                                      {"amb03.png", "01"}}) {
    save_png(noise(80, 60, 4), course.folder / name);
    CHECK(has(course.say(name).out, "The nearest picture is " + std::string(chapter) + "'s"));
  }
}

TEST_CASE("mistakes that have a card in My Earth is ... lead to it") {
  const Course course;
  std::vector<WrongPicture> wrong = mistaken_maps(third);
  for (const char* words : {"dark at the outline: the cosine", "shining on its night side: the",
                            "dents and not bumps: the height", "too dark: light was written"})
    wrong.push_back({words, words, {}});
  std::string cards;
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    const std::vector<WrongPicture> one{
        {"one", wrong[i].words, noise(80, 60, static_cast<std::uint32_t>(i))}};
    course.know("01_a", one);
    save_png(one[0].picture, course.folder / "my.png");
    const std::string out = course.say("my.png --chapter 01").out;
    CHECK(has(out, wrong[i].words));
    const std::size_t at = out.find("symptoms.html#");
    if (at != std::string::npos) cards += out.substr(at + 14, out.find('\n', at) - at - 14) + " ";
  }
  CHECK(cards ==
        "mirrored upside_down half_turn quarter_turn quarter_turn stripes squeezed_pole "
        "half_a_texel half_a_texel half_a_texel half_a_texel too_dark too_pale black dark_rim "
        "night_highlight dents too_dark ");
}

TEST_CASE("a picture is judged with the texture that its reader names") {
  const struct {
    const char *words, *said;
    int status;
  } rows[] = {
      {"03_image_texture.png\" --texture earth.png",
       ": right, chapter 03's picture with that texture", 0},
      {"03_image_texture.png\" --texture crate.png", ": wrong with that texture", 1},
      {"01_plain_spheres.png\" --texture crate.png", "none of these chapters has a texture", 2},
  };
  for (const auto& row : rows) {
    CAPTURE(row.words);
    const Outcome outcome =
        run(std::string("\"" TEXMAP_DIAGNOSE "\" \"" TEXMAP_TESTS_DIR "/golden/") + row.words);
    CHECK(outcome.status == row.status);
    CHECK(has(outcome.out + outcome.err, row.said));
  }
}
