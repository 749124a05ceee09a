// ./course diagnose: which chapter's picture it is, what is wrong with it, and where that is
// explained.
#include <doctest.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "engine/compare/known_mistakes.hpp"
#include "engine/draw/render.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"
#include "math/srgb.hpp"
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
  [[nodiscard]] Outcome say(const std::string& words) const {
    return run("cd \"" + folder.path() + "\" && \"" TEXMAP_DIAGNOSE "\" --source chapters " +
               words);
  }
};

}  // namespace

TEST_CASE("a picture gets its chapter, its mistake and the pages, and what is none the remedy") {
  const Course course;
  save_png(with_noise(third, 1, 5), course.folder / "right.png");
  Image dark = third;
  for (Rgb8& p : dark.pixels)
    p = {byte_of(srgb_decode(p.r / 255.0)), byte_of(srgb_decode(p.g / 255.0)),
         byte_of(srgb_decode(p.b / 255.0))};
  save_png(dark, course.folder / "wrong.png");
  save_png(mirrored(first), course.folder / "whole.png");
  save_png(noise(80, 60, 1), course.folder / "noise.png");
  save_png(ramps(30, 30), course.folder / "small.png");
  save_png(noise(40, 60, 1), course.folder / "seven.png");
  write_text_atomically(path_of(course.folder / "text.png"), "no picture");
  write_text_atomically(path_of(course.folder / "out/07_d.html"), "the book");
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
      {"wrong.png", 1,
       "wrong.png: wrong. Chapter 03's picture, too dark: light was written|change      |"
       "out/symptoms.html#too_dark|docs/symptoms.md (./course|chapter 07: "
       "out/07_d.html\n|file://|/out/07_d.html\n|--chapter NN\n"},
      {"wrong.png --beside tests/golden/03_b.png", 0, "The first: too dark: light was written"},
      {"tests/golden/03_b.png --beside wrong.png", 0, "The second: too dark: light was written"},
      {"tests/golden/03_b.png --beside noise.png", 0, ""},
      {"wrong.png --beside noise.png", 0, ""},
      {"whole.png", 1, "Chapter 01's picture, the whole picture is mirrored|out/01_a.html"},
      {"noise.png", 1, "noise.png: wrong, by a mistake that is not known|./course diff noise"},
      {"seven.png", 1, "a mistake that is not known"},
      {"seven.png --first", 3, ""},
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
  // The name made the choice, and may be wrong.
  CHECK(has(course.say("my_03.png").out, "--chapter NN\n"));
}

TEST_CASE("mistakes that have a card in My Earth is ... lead to it") {
  const TemporaryFolder folder;
  const Image map = load_image(TEXMAP_ASSETS_DIR "/earth.png");
  std::string cards;
  for (const WrongPicture& wrong : mistaken_maps(map)) {
    if (wrong.name.find("texel_") != std::string::npos || wrong.name.find("gray") == 0) continue;
    save_png(wrong.picture, folder / "map.png");
    REQUIRE(run("\"" TEXMAP_CHAPTER_03 "\" --quiet --texture \"" + (folder / "map.png") +
                "\" --out \"" + (folder / "my.png") + "\"")
                .status == 0);
    const std::string out =
        run("\"" TEXMAP_DIAGNOSE "\" --chapter 3 \"" + (folder / "my.png") + "\"").out;
    const std::size_t at = out.find("symptoms.html#");
    if (at != std::string::npos) cards += out.substr(at + 14, out.find('\n', at) - at - 14) + " ";
  }
  CHECK(
      cards ==
      "mirrored upside_down half_turn quarter_turn stripes squeezed_pole too_dark too_pale black ");
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
