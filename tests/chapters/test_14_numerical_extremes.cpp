// Chapter 14: what it says is broken is broken, what it says holds holds, and its judge has enough digits.
#include <doctest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "14_numerical_extremes/lesson.hpp"
#include "compare/running.hpp"
#include "many_digits.hpp"
#include "pictures.hpp"

#ifdef TEXMAP_HAVE_DIGITS
#include "extremes/digits.hpp"

template <>
inline texmap::Digits50 texmap::pi<texmap::Digits50>() {
  return texmap::extremes::circle<texmap::Digits50>();
}
#endif

using namespace texmap;
using namespace texmap::chapter_14;

namespace {

/// The sheet as the program draws it.
const Sheet& sheet() {
  static const Sheet drawn = [] {
    CommandLine line("test", "");
    Studio studio("test", line);
    studio.prefer_size(1680, 1330);
    return draw_sheet(Lesson{}.exhibits(), studio);
  }();
  return drawn;
}

std::vector<std::string> names() {
  std::vector<std::string> listed;
  std::apply([&](const auto&... each) { (listed.emplace_back(each.name), ...); }, Lesson{}.exhibits());
  return listed;
}

Mistakes mistakes(const std::string& name, Way way) {
  const auto all = names();
  const auto at = std::find(all.begin(), all.end(), name);
  REQUIRE(at != all.end());
  return sheet().mistakes[static_cast<std::size_t>(at - all.begin())][way];
}

}  // namespace

TEST_CASE("the course's formulas miss nothing in any exhibit, and no pixel in double is wrong") {
  for (const std::string& name : names()) {
    CAPTURE(name);
    CHECK(mistakes(name, robust_double).wrong == 0);
    CHECK(mistakes(name, robust_double).missed == 0);
    CHECK(static_cast<double>(mistakes(name, robust_double).texels) <= 1e-10);
    CHECK(mistakes(name, robust_float).wrong <= 8);  // of 30,000: edges that pass within a rounding of a pixel's center
    CHECK(mistakes(name, robust_float).missed == 0);
    CHECK(static_cast<double>(mistakes(name, robust_float).texels) <= 0.1);
  }
}

TEST_CASE("the seeds' formulas break where the chapter says they do") {
  const std::map<std::string, int> broken_in_float = {
      {"from-1e3", 3000}, {"from-1e5", 20000}, {"from-1e7", 20000}, {"pole", 2000},   {"seam", 500},
      {"far-home", 1000}, {"units", 20000},    {"acne", 300},       {"small", 10000}, {"needle", 5000},
      {"turns", 10000},   {"highlight", 300},  {"far-floor", 5000}};
  for (const auto& entry : broken_in_float) {
    CAPTURE(entry.first);
    CHECK(mistakes(entry.first, plain_float).wrong >= entry.second);
  }
  // More digits mend rounding, and not a wrong bound or a wrong sign.
  for (const std::string& name : names()) {
    CAPTURE(name);
    const bool broken = name == "from-1e7" || name == "small" || name == "highlight";
    CHECK((mistakes(name, plain_double).wrong > 100) == broken);
  }
}

TEST_CASE("the table of the chapter's page is the one that its program prints") {
  std::ifstream file(std::string(TEXMAP_TESTS_DIR) + "/../chapters/14_numerical_extremes/README.md");
  std::stringstream page;
  page << file.rdbuf();
  REQUIRE(page.str().size() > 1000);
#ifdef TEXMAP_REFERENCE_PLATFORM
  CHECK(page.str().find(sheet().table) != std::string::npos);
#endif
  for (const std::string& name : names()) CHECK(page.str().find(name) != std::string::npos);
}

#ifdef TEXMAP_HAVE_DIGITS
namespace {

using Fifty = Digits50;

/// How many of the sampled pixels the judge sees otherwise than fifty digits do.
template <class Exhibit>
int misjudged(const Exhibit& exhibit) {
  const int width = 200;
  const int height = 150;
  const View view = view_of(exhibit.camera, width, height);
  int wrong = 0;
  for (int i = 0; i < 120; ++i) {
    const int column = i * 37 % width;
    const int row = i * 59 % height;
    const Sight<long double> judge =
        exhibit(ray_through(view, static_cast<long double>(column), static_cast<long double>(row)), Care::robust);
    const Sight<Fifty> truth = exhibit(ray_through(view, Fifty(column), Fifty(row)), Care::robust);
    const auto differ = [](long double a, const Fifty& b) { return abs(Fifty(a) - b) > Fifty(1e-13); };
    const bool same_color = !differ(judge.color.r, truth.color.r) && !differ(judge.color.g, truth.color.g);
    const bool same_place =
        !truth.mapped || (!differ(judge.uv.v, truth.uv.v) && !differ(judge.uv.u * judge.round, truth.uv.u * truth.round));
    wrong += judge.hit == truth.hit && same_color && same_place ? 0 : 1;
  }
  return wrong;
}

}  // namespace

TEST_CASE("the judge of every exhibit, extended precision, sees what fifty digits see") {
  const auto check = [](const auto& exhibit) {
    CAPTURE(exhibit.name);
    CHECK(misjudged(exhibit) == 0);
  };
  std::apply([&](const auto&... each) { (check(each), ...); }, Lesson{}.exhibits());
}
#endif

TEST_CASE("an exhibit drawn alone is the one of the sheet, and a wrong name is told the right ones") {
  CommandLine line("test", "");
  Studio studio("test", line);
  const std::array<const char*, 3> chosen = {"test", "--number", "double"};
  REQUIRE(line.parse(3, chosen.data()));
  studio.width = 201;
  studio.height = 156;
  studio.out = "/nowhere/x.png";
  std::string told;
  try {
    show_exhibit(Lesson{}.exhibits(), "equator", Care::robust, studio);
  } catch (const UsageError& error) {
    told = error.what();
  }
  for (const std::string& name : names()) CHECK(told.find(name) != std::string::npos);

  const auto exhibits = Lesson{}.exhibits();
  const Image pole = draw_alone(std::get<4>(exhibits), Care::robust, studio);
  CHECK(test::count_different(pole, draw_alone(std::get<4>(exhibits), Care::plain, studio), 1) == 0);
  studio.number = Number::float_;
  CHECK(test::count_different(pole, draw_alone(std::get<4>(exhibits), Care::plain, studio), 1) > 1000);
}

TEST_CASE("alone, an exhibit is drawn with the number that was chosen, extended too") {
  CommandLine line("test", "");
  Studio studio("test", line, Offered::single);
  studio.width = 201;
  studio.height = 156;
  const auto from_1e7 = std::get<3>(Lesson{}.exhibits());
  const Image in_double = draw_alone(from_1e7, Care::plain, studio);
  studio.number = Number::extended;
  CHECK(test::count_different(in_double, draw_alone(from_1e7, Care::plain, studio), 1) > 1000);
  CHECK(test::count_different(draw_alone(from_1e7, Care::robust, studio), draw_alone(from_1e7, Care::plain, studio), 1) < 100);
}

TEST_CASE("the seam's other name, u = 1, is outside the texture, and the course's formula never gives it") {
  const Globe<Graticule> globe{"", "", {}, {{0, 0, 0}, 1}, {}};
  const Ray<double> to_the_seam{{-5, 0, -0.0}, {1, 0, -0.0}};
  const Sight<double> plain = globe(to_the_seam, Care::plain);
  REQUIRE(plain.hit);
  CHECK(plain.uv.u == 1);
  CHECK_FALSE(plain.mapped);
  CHECK(plain.color.g == no_texel.g);
  CHECK(globe(to_the_seam, Care::robust).mapped);
}

TEST_CASE("what only one exhibit has a use for is refused for the sheet") {
  for (const char* const option : {"--number float", "--samples 2", "--formulas seeds"}) {
    CAPTURE(option);
    const test::TemporaryFolder folder;
    const test::Outcome outcome = test::run(std::string(TEXMAP_CHAPTER) + " --quiet --width 20 --height 20 " + option +
                                            " --out '" + (folder / "x.png") + "'");
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find("need --exhibit NAME") != std::string::npos);
  }
}

TEST_CASE("the chapter offers the numbers that its formulas can calculate with, and nothing for packs") {
  const std::string program = std::string(TEXMAP_CHAPTER) + " --quiet --exhibit pole --formulas seeds --width 80 --height 60 ";
  const test::TemporaryFolder folder;
  using test::bytes_of;
  for (const char* const number : {"float", "double", "extended"}) {
    CAPTURE(number);
    CHECK(test::run(program + "--number " + number + " --out '" + (folder / number) + ".png'").status == 0);
  }
  CHECK(test::run(program + "--out '" + (folder / "unsaid.png") + "'").status == 0);
  CHECK(bytes_of(folder / "unsaid.png") == bytes_of(folder / "double.png"));
  CHECK_FALSE(bytes_of(folder / "float.png") == bytes_of(folder / "double.png"));
  for (const char* const option : {"--number float-pack", "--number double-pack", "--number interval"}) {
    CAPTURE(option);
    const test::Outcome outcome = test::run(program + option);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find("float|double|extended,") != std::string::npos);
  }
  CHECK(test::run(program + "--instructions baseline").status == 2);
  const std::string help = test::run(std::string(TEXMAP_CHAPTER) + " --help").out;
  CHECK(help.find("--number") != std::string::npos);
  CHECK(help.find("--instructions") == std::string::npos);
  CHECK(help.find("pack") == std::string::npos);
}
