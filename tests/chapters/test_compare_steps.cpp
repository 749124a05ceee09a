// What ./course diff says about two steps.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "01_plain_spheres/lesson.hpp"
#include "02_checkerboard_uv/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "comparison.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"
#include "support/pictures.hpp"
#include "support/running.hpp"
#include "support/temporary_folder.hpp"
#include "tools/page/page.hpp"

using namespace texmap;
using namespace texmap::test;
using steps::DrawnStep;

namespace {

constexpr steps::Drawing small{200, 150};

const DrawnStep& first() {
  static const auto step = steps::draw_step<chapter_01::Lesson>("01_plain_spheres", small);
  return step;
}
const DrawnStep& second() {
  static const auto step = steps::draw_step<chapter_02::Lesson>("02_checkerboard_uv", small);
  return step;
}
constexpr ObjectSet declared = chapter_02::Lesson::about.changed_objects;

/// All that is said of a comparison.
std::string said_of(const steps::Comparison& result) {
  return steps::report_json(result) + steps::report_page(result, {}, {}, {}) +
         steps::summary(result, "page");
}

std::string files_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  std::string all;
  for (const std::string& name : names) all += name + " ";
  return all;
}

}  // namespace

TEST_CASE("a step that changes what it declares, and nothing else, has nothing elsewhere") {
  const steps::Comparison result = steps::compare(first(), second(), declared);
  CHECK(result.changed_inside == result.figures.pixels_different);
  CHECK(result.changed_inside > 5000);
  CHECK(result.pixels_with_uv == 0);
  const std::string said = said_of(result);
  for (const std::string& part :
       {std::string("\"only_declared_changed\": true"), std::string("\"changed_elsewhere\": 0,"),
        std::string("Only what may change has changed: the step declares middle, right, ground."),
        page::inside(first().picture).address, page::inside(second().picture).address})
    CHECK(has(said, part));
  // An object that is not declared counts as elsewhere.
  CHECK(steps::compare(first(), second(), {0, 2}).changed_elsewhere > 1000);
}

TEST_CASE("one stray pixel outside the declared objects is found, with its place") {
  DrawnStep stray = second();
  stray.picture.at(7, 3).g ^= 1;
  const std::string said = said_of(steps::compare(first(), stray, declared));
  for (const char* part : {"\"first_changed_elsewhere\": {\"column\": 7, \"row\": 3}",
                           "1 pixels changed that should not have", "at column 7, row 3.",
                           "elsewhere  1 pixels changed", "elsewhere</th><td>1</td>"})
    CHECK(has(said, part));
  // An object that moved may change the pixels that it left.
  stray.objects[3 * 200 + 7] = chapter_02::middle;
  CHECK(steps::compare(first(), stray, declared).changed_elsewhere == 0);
  CHECK(steps::compare(stray, first(), declared).changed_elsewhere == 0);
}

TEST_CASE(
    "a quarter turn is a quarter of u and nothing of v, wherever both steps have texture "
    "coordinates") {
  const auto turned = steps::draw_step<chapter_05::Lesson>("05_y_rotation", small);
  const steps::Comparison result = steps::compare(second(), turned);
  CHECK(result.largest_du == doctest::Approx(0.25).epsilon(1e-12));
  CHECK(result.largest_dv < 1e-12);
  CHECK(result.pixels_with_uv > 10000);
  CHECK(has(said_of(result), "<td>0.25 of a turn, "));
  // Turned by 0.9, which is 0.1 the short way round, and upside down.
  DrawnStep moved = second();
  for (Uv<double>& uv : moved.uv) uv = {std::fmod(uv.u + 0.9, 1), 1 - uv.v};
  CHECK(steps::compare(second(), moved).largest_du == doctest::Approx(0.1));
  CHECK(steps::compare(second(), moved).largest_dv > 0.9);
}

TEST_CASE("of chapters without pixels to compare the page shows the code and says why") {
  const TemporaryFolder folder;
  const std::string program = "\"" TEXMAP_COMPARE_STEPS "\" --drawn '" + folder.path() +
                              "' --out '" + folder.path() + "' --from ";
  const struct {
    const char *numbers, *place, *why, *before, *after;
  } pairs[] = {
      {"0 --to 01", "00-01", "00_one_file draws a scene of its own, so no pixels are compared",
       "int main(", "struct Lesson"},
      {"7 --to 13", "07-13",
       "07_earth_by_sampling and 13_speed_for_accuracy draw scenes of their own",
       "- namespace texmap::chapter_07 {", "+ namespace texmap::chapter_13 {"},
  };
  for (const auto& pair : pairs) {
    CAPTURE(pair.numbers);
    const Outcome outcome = run(program + pair.numbers);
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    CHECK(has(outcome.out, pair.why));
    const std::string page = text_in((folder / pair.place) + "/index.html");
    for (const char* part : {pair.why, pair.before, pair.after, "src=\"data:image/png"})
      CHECK(has(page, part));  // golden pictures, in the page
    CHECK_FALSE(has(page, "Figures"));
    CHECK(files_in(folder / pair.place) == "index.html ");
  }
}

TEST_CASE("pages of neighbours share the chapters' pictures, where those are what was compared") {
  const TemporaryFolder folder;
  save_png(first().picture, folder / "00_same.png");  // an earlier chapter that drew the same
  Image other = second().picture;
  other.at(0, 0).r ^= 1;  // as a picture drawn with other options
  save_png(other, folder / (second().name + ".png"));
  const std::string program = "\"" TEXMAP_COMPARE_STEPS "\" --shared --drawn '" + folder.path() +
                              "' --out '" + folder.path() +
                              "/diff' --width 200 --height 150 --from 1 --to 2";
  CHECK(run(program).status == 0);
  const std::filesystem::path place = folder / "diff/01-02";
  const std::string page = text_in(place / "index.html");
  CHECK(has(page, "src=\"../../00_same.png\""));
  CHECK(has(page, "src=\"after.png\""));
  CHECK_FALSE(has(page, "base64"));
  CHECK((load_image(place / "after.png") == second().picture));
  CHECK(files_in(place) ==
        "after.png after_close.png before_close.png difference.png index.html report.json ");
}

TEST_CASE("two pictures are compared on a page of the same kind, and the status says what it is") {
  const TemporaryFolder folder;
  save_png(first().picture, folder / "a.png");
  save_png(second().picture, folder / "b.png");
  save_png(Image(4, 3), folder / "small.png");
  save_png(mirrored(first().picture), folder / "mirrored.png");
  std::filesystem::create_directories(folder / "nobody");
  for (const auto& [file, text] : std::vector<std::pair<std::string, std::string>>{
           {"ada/chapters/01_a/lesson.hpp", "int same;\nint one;\n"},
           {"bob/chapters/01_a/lesson.hpp", "int same;\nint two;\n"},
           {"ada/chapters/01_a/exercises/1_b.hpp", "int mine;\n"},
           {"bob/chapters/01_a/own.hpp", "int own;\n"},
           {"ada/chapters/01_a/main.cpp", "int main() {}\n"},
           {"bob/chapters/01_a/main.cpp", "int main() {}\n"},
           {"j.doe/chapters/01_a/own.hpp", "int own;\n"},
           {"a.smith/chapters/01_a/own.hpp", "int own;\n"}}) {
    std::filesystem::create_directories(std::filesystem::path(folder / file).parent_path());
    write_text_atomically(path_of(folder / file), text);
  }
  const struct {
    const char* names;
    int status;
    const char* said;
  } rows[] = {
      {"a.png --to b.png", 1, "of 30000 pixels by more than one level"},
      {"a.png --to a.png", 0,
       "different: 0 of 30000 pixels by more than one level (0 %), 0 by one\n"
       "Look at out/diff/a.png-a.png/"},
      {"a.png --to mirrored.png --out known --mistake 'The second: mirrored'", 1,
       " by one\nThe second: mirrored\nLook at"},
      {"ada --to bob/chapters", 1,
       "different: 01_a/exercises/1_b.hpp, 01_a/lesson.hpp, 01_a/own.hpp\nLook at "
       "out/diff/ada-chapters/"},
      {"ada --to ada", 0, "different: no file\n"},
      {"j.doe --to a.smith", 0, "different: no file\n"},
      {"ada --to nobody", 2, "there are no chapters in 'nobody'"},
      {"a.png --to small.png", 2, "the pictures differ in size: 200 x 150 and 4 x 3 pixels"},
      {"a.png --to none.png", 2, "cannot load 'none.png'"},
      {"06 --to 99", 2, "error: there is no chapter '99': name two of 00 to 14, two picture"},
      {"07 --to x", 2, "error: there is no chapter 'x'"},
      {"06 --to 007", 2, "error: there is no chapter '007'"},
      {"a.png --to 06", 2, "error: there is no chapter 'a.png'"},
  };
  for (const auto& row : rows) {
    CAPTURE(row.names);
    const Outcome outcome =
        run("cd '" + folder.path() + "' && '" TEXMAP_COMPARE_STEPS "' --from " + row.names);
    CHECK(outcome.status == row.status);
    CHECK(has(outcome.out + outcome.err, row.said));
  }
  const std::string code = text_in(folder / "out/diff/ada-chapters/index.html");
  for (const char* part : {"- int one;", "+ int two;", "+ int own;", "======== 01_a/lesson.hpp"})
    CHECK(has(code, part));
  CHECK_FALSE(has(code, "int main"));
  CHECK(has(text_in(folder / "known/a.png-mirrored.png/index.html"),
            "by one. The second: mirrored."));
  const std::string page = text_in(folder / "out/diff/a.png-b.png/index.html");
  CHECK(has(page, "<h1>From a.png to b.png</h1>"));
  CHECK(has(page, "<th scope=\"row\">SSIM</th>"));
  CHECK(has(text_in(folder / "out/diff/a.png-a.png/index.html"), "The pictures are the same"));
}

TEST_CASE("chapter 04 differs from 03 by a convention that is not 03's, and the page names it") {
  const TemporaryFolder folder;
  const std::string program =
      "\"" TEXMAP_COMPARE_STEPS "\" --width 200 --height 150 --out '" + folder.path() + "' --from ";
  const auto compared = [&](const char* numbers, const char* place) {
    CHECK(run(program + numbers).status == 0);
    const std::filesystem::path pages = folder / place;
    return text_in(pages / "index.html") + text_in(pages / "report.json");
  };
  const std::string forward = compared("03 --to 04", "03-04");
  CHECK(has(forward, "<h1>From 03_image_texture to 04_uv_conventions --convention daily</h1>"));
  CHECK(has(forward, "\"only_declared_changed\": true"));
  CHECK(forward.find("\"changed_inside\": 0") == std::string::npos);
  CHECK(forward.find("\"largest_du_turns\": 0,") == std::string::npos);
  // Chapter 05 goes on with the convention of 03.
  CHECK(has(compared("04 --to 05", "04-05"), "<h1>From 04_uv_conventions to 05_y_rotation</h1>"));
}
