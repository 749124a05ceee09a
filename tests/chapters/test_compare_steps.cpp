// What ./course diff says about two steps.
#include <doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "01_plain_spheres/lesson.hpp"
#include "02_checkerboard_uv/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "comparison.hpp"
#include "engine/compare/difference_map.hpp"
#include "engine/picture/load_image.hpp"
#include "engine/picture/save_png.hpp"
#include "support/running.hpp"
#include "support/shown_values.hpp"
#include "support/temporary_folder.hpp"
#include "tools/page/page.hpp"

using namespace texmap;
using namespace texmap::test;
using steps::DrawnStep;

namespace {

const DrawnStep& first() {
  static const DrawnStep step =
      steps::draw_step<chapter_01::Lesson>("01_plain_spheres", 200, 150, 1);
  return step;
}
const DrawnStep& second() {
  static const DrawnStep step =
      steps::draw_step<chapter_02::Lesson>("02_checkerboard_uv", 200, 150, 1);
  return step;
}

std::string text_in(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
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
  const steps::Comparison result = steps::compare(first(), second(), second().may_change);
  CHECK(result.changed_elsewhere == 0);
  CHECK(result.changed_inside == result.figures.pixels_different);
  CHECK(result.changed_inside > 5000);
  CHECK(result.stray_column == -1);
  CHECK(steps::report_json(result).find("\"only_declared_changed\": true") != std::string::npos);
  const std::string page = steps::report_page(result, "", "");
  CHECK(page.find("Only what may change has changed") != std::string::npos);
  CHECK(page.find(page::inside(first().picture).address) != std::string::npos);
  CHECK(page.find(page::inside(second().picture).address) != std::string::npos);
  // An object that is not declared counts as elsewhere.
  CHECK(steps::compare(first(), second(), {0, 2}).changed_elsewhere > 1000);
}

TEST_CASE("one stray pixel outside the declared objects is found, with its place") {
  DrawnStep stray = second();
  stray.picture.at(7, 3).g ^= 1;
  const steps::Comparison result = steps::compare(first(), stray, stray.may_change);
  CHECK(result.changed_elsewhere == 1);
  CHECK(result.stray_column == 7);
  CHECK(result.stray_row == 3);
  CHECK(steps::report_json(result).find(
            "\"first_changed_elsewhere\": {\"column\": 7, \"row\": 3}") != std::string::npos);
  CHECK(steps::report_page(result, "", "").find("1 pixels changed that should not have") !=
        std::string::npos);
  CHECK(steps::summary(result, "page").find("elsewhere  1 pixels") != std::string::npos);
}

TEST_CASE("an object that moved may change the pixels that it left") {
  DrawnStep before = first();
  DrawnStep after = first();
  after.picture.at(5, 5) = {1, 2, 3};
  before.objects[5 * 200 + 5] = chapter_01::left;
  CHECK(steps::compare(before, after, {chapter_01::left}).changed_elsewhere == 0);
  CHECK(steps::compare(before, after, {chapter_01::right}).changed_elsewhere == 1);
}

TEST_CASE(
    "a quarter turn is a quarter of u and nothing of v, wherever both steps have texture "
    "coordinates") {
  const DrawnStep turned = steps::draw_step<chapter_05::Lesson>("05_y_rotation", 200, 150, 1);
  const steps::Comparison result = steps::compare(second(), turned, turned.may_change);
  CHECK(result.largest_du == doctest::Approx(0.25).epsilon(1e-12));
  CHECK(result.largest_dv < 1e-12);
  CHECK(result.pixels_with_uv > 10000);
  CHECK(steps::compare(first(), second(), {}).pixels_with_uv == 0);
}

TEST_CASE("the map of texture coordinates shows |du| and |dv|, and gray where a step has none") {
  steps::Comparison pixels;
  pixels.before.picture = Image(2, 1);
  pixels.before.uv = {{0.95, 0.25}, {std::nan(""), 0}};
  pixels.after.uv = {{0.2, 1}, {0, 0}};
  const Image map = steps::uv_difference_map(pixels);
  CHECK(map.width == 4);
  CHECK(map.at(0, 0) == difference_color(127));  // a quarter of a turn, the short way round
  CHECK(map.at(2, 0) == difference_color(191));
  CHECK(map.at(1, 0) == Rgb8{128, 128, 128});
  CHECK(map.at(3, 0) == Rgb8{128, 128, 128});
}

TEST_CASE("the box of changed coordinates is around all pixels that have others") {
  DrawnStep turned = second();
  const std::size_t place = 75 * 200 + 100;  // on the globe
  REQUIRE_FALSE(std::isnan(turned.uv[place].u));
  turned.uv[place].u += 0.25;
  turned.uv[place + 201].v += 0.25;
  const steps::Comparison result = steps::compare(second(), turned, {});
  CHECK((result.uv_box == Box{100, 75, 2, 2}));
  CHECK((steps::compare(second(), second(), {}).uv_box == Box{}));
}

TEST_CASE("the page has the map where both steps have texture coordinates") {
  const auto page_after = [](const DrawnStep& before) {
    return steps::report_page(steps::compare(before, second(), {}), "", "");
  };
  DrawnStep upside_down = second();
  for (Uv<double>& uv : upside_down.uv) uv.v = 1 - uv.v;
  CHECK(page_after(upside_down).find("<h2>Texture coordinates</h2>") != std::string::npos);
  CHECK(page_after(first()).find("<h2>Texture coordinates</h2>") == std::string::npos);
  CHECK(page_after(second()).find("they have the same.") != std::string::npos);
}

TEST_CASE("of chapters without pixels to compare the page shows the code and says why") {
  const TemporaryFolder folder;
  const std::string program = "\"" TEXMAP_COMPARE_STEPS "\" --drawn '" + folder.path() +
                              "' --out '" + folder.path() + "' --from ";
  struct Pair {
    const char* numbers;
    const char* place;
    const char* why;
    const char* before;
    const char* after;
  };
  constexpr std::array pairs = {
      Pair{"0 --to 01", "00-01", "00_one_file draws a scene of its own, so no pixels are compared",
           "int main(", "struct Lesson"},
      Pair{"7 --to 13", "07-13",
           "07_earth_by_sampling and 13_speed_for_accuracy draw scenes of their own",
           "- namespace texmap::chapter_07 {", "+ namespace texmap::chapter_13 {"}};
  for (const Pair& pair : pairs) {
    CAPTURE(pair.numbers);
    const Outcome outcome = run(program + pair.numbers);
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    CHECK(outcome.out.find(pair.why) != std::string::npos);
    const std::string page = text_in(std::filesystem::path(folder / pair.place) / "index.html");
    CHECK(page.find(pair.why) != std::string::npos);
    CHECK(page.find(pair.before) != std::string::npos);
    CHECK(page.find(pair.after) != std::string::npos);
    CHECK(page.find("pixels that differ") == std::string::npos);
    CHECK(page.find("src=\"data:image/png") != std::string::npos);  // golden pictures, in the page
    CHECK(files_in(folder / pair.place) == "index.html ");
  }
}

TEST_CASE("pages of neighbours share the chapters' pictures, where those are what was compared") {
  const TemporaryFolder folder;
  save_png(first().picture, folder / "00_same.png");  // an earlier chapter that drew the same
  Image other = second().picture;
  other.at(0, 0).r ^= 1;  // as a picture drawn with other options
  save_png(other, folder / (second().chapter + ".png"));
  const std::string program = "\"" TEXMAP_COMPARE_STEPS "\" --shared --drawn '" + folder.path() +
                              "' --out '" + folder.path() +
                              "/diff' --width 200 --height 150 --from 1 --to 2";
  CHECK(run(program).status == 0);
  const std::filesystem::path place = folder / "diff/01-02";
  const std::string page = text_in(place / "index.html");
  CHECK(page.find("src=\"../../00_same.png\"") != std::string::npos);
  CHECK(page.find("src=\"after.png\"") != std::string::npos);
  CHECK(page.find("base64") == std::string::npos);
  CHECK((load_image(place / "after.png") == second().picture));
  CHECK(files_in(place) ==
        "after.png after_close.png before_close.png difference.png index.html report.json ");
}

TEST_CASE("two pictures are compared on a page of the same kind, and the status says what it is") {
  const TemporaryFolder folder;
  save_png(first().picture, folder / "a.png");
  save_png(second().picture, folder / "b.png");
  save_png(Image(4, 3), folder / "small.png");
  const auto compared = [&](const std::string& a, const std::string& b) {
    return run("cd '" + folder.path() + "' && '" TEXMAP_COMPARE_STEPS "' --from " + a + " --to " +
               b);
  };
  const Outcome different = compared("a.png", "b.png");
  CHECK(different.status == 1);
  CHECK(different.out.find("of 30000 pixels differ") != std::string::npos);
  CHECK(different.out.find("out/diff/a.png-b.png/index.html") != std::string::npos);
  const std::string page = text_in(folder / "out/diff/a.png-b.png/index.html");
  CHECK(page.find("<h1>From a.png to b.png</h1>") != std::string::npos);
  CHECK(page.find("<th scope=\"row\">SSIM</th>") != std::string::npos);
  CHECK(page.find("ms became") == std::string::npos);
  const Outcome same = compared("a.png", "a.png");
  CHECK(same.status == 0);
  CHECK(text_in(folder / "out/diff/a.png-a.png/index.html").find("The pictures are the same") !=
        std::string::npos);

  const Outcome sizes = compared("a.png", "small.png");
  CHECK(sizes.status == 2);
  CHECK(sizes.err.find("the pictures differ in size: 200 x 150 and 4 x 3 pixels") !=
        std::string::npos);
  const Outcome missing = compared("a.png", "none.png");
  CHECK(missing.status == 2);
  CHECK(missing.err.find("cannot load 'none.png'") != std::string::npos);
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
  CHECK(forward.find("<h1>From 03_image_texture to 04_uv_conventions --convention daily</h1>") !=
        std::string::npos);
  CHECK(forward.find("\"only_declared_changed\": true") != std::string::npos);
  CHECK(forward.find("\"changed_inside\": 0") == std::string::npos);
  CHECK(forward.find("\"largest_du_turns\": 0,") == std::string::npos);
  // Chapter 05 goes on with the convention of 03.
  CHECK(compared("04 --to 05", "04-05").find("<h1>From 04_uv_conventions to 05_y_rotation</h1>") !=
        std::string::npos);
}

TEST_CASE("a chapter that cannot be compared is named, and those that can be") {
  const std::string program = "\"" TEXMAP_COMPARE_STEPS "\" --from ";
  for (const char* const numbers :
       {"06 --to 99", "99 --to 06", "07 --to x", "06 --to 007", "a.png --to 06"}) {
    CAPTURE(numbers);
    const Outcome outcome = run(program + numbers);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find("error: there is no chapter '") != std::string::npos);
    CHECK(outcome.err.find("name two of 00 to 14, or two picture files") != std::string::npos);
  }
}
