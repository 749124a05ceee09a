// Chapter 14 judged by pairs of doubles, as where long double is double: CMake compiles its sources
// once more for this suite, with TEXMAP_JUDGE_PAIR.
#include <doctest.h>

#include "14_numerical_extremes/lesson.hpp"
#include "engine/picture/load_image.hpp"
#include "support/pictures.hpp"
#include "support/running.hpp"
#include "support/shown_values.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap;
using namespace texmap::chapter_14;

static_assert(judge_is_pair);

namespace {

const Sheet& sheet() {
  static const Sheet drawn = [] {
    CommandLine line("test", "");
    Session session("test", line, Lesson::about);
    return draw_sheet(Lesson{}.exhibits(), session);
  }();
  return drawn;
}

}  // namespace

TEST_CASE("the sheet is the golden one, drawn where the judge is long double") {
  const Image golden =
      load_image(std::string(TEXMAP_TESTS_DIR) + "/golden/14_numerical_extremes.png");
  const auto different = test::count_different(sheet().picture, golden, 1);
  CHECK(different <= 638);  // 0.02 %, as test_golden allows
#ifdef TEXMAP_REFERENCE_PLATFORM
  CHECK(different == 0);  // judged by double it is 359
#endif
}

TEST_CASE("the judge finds errors in double, which double does not find in itself") {
  int textured = 0;
  for (const auto& mistakes : sheet().mistakes) {
    if (!(mistakes[published_float].texels > Judge(0))) continue;
    ++textured;
    const auto texels = static_cast<double>(mistakes[robust_double].texels);
    CHECK(texels > 0);
    CHECK(texels < 1e-10);
  }
  CHECK(textured == 12);
}

#ifdef TEXMAP_REFERENCE_PLATFORM
TEST_CASE("every exhibit has the figures of the chapter's page, judged there by long double") {
  const auto bytes =
      test::bytes_of(TEXMAP_TESTS_DIR "/../chapters/14_numerical_extremes/README.md");
  const std::string page(bytes.begin(), bytes.end());
  const auto figures = sheet().table.find("judge: pairs of doubles, 102 bits");
  REQUIRE(figures != std::string::npos);
  CHECK(page.find(sheet().table.substr(0, figures) + "judge: long double, 64 bits") !=
        std::string::npos);
}
#endif

#ifndef TEXMAP_ONE_NUMBER  // the programs of the build for learning have one
TEST_CASE("the chapter offers the numbers that its formulas run with, and nothing for packs") {
  const std::string program =
      "\"" TEXMAP_CHAPTER "\" --quiet --exhibit pole --width 80 --height 60 ";
  const test::TemporaryFolder folder;
  const auto picture = [&](const std::string& options) {
    CAPTURE(options);
    CHECK(test::run(program + options + " --out \"" + (folder / "x.png") + "\"").status == 0);
    return test::bytes_of(folder / "x.png");
  };
  const auto in_float = picture("--formulas published --number float");
  const auto in_double = picture("--formulas published --number double");
  CHECK(in_float != in_double);
  CHECK(picture("--formulas published") == in_double);
  CHECK(picture("--formulas seeds --number float") == in_float);  // an older word
  CHECK(picture("--number float") == picture("--formulas robust --number float"));
  CHECK(picture("--number float") != in_float);
  for (const char* const number : {"float-pack", "double-pack", "interval"}) {
    CAPTURE(number);
    const test::Outcome outcome = test::run(program + "--number " + number);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find("float|double|extended,") != std::string::npos);
  }
  CHECK(test::run(program + "--instructions baseline").status == 2);
  CHECK(test::run("\"" TEXMAP_CHAPTER "\" --help").out.find("pack") == std::string::npos);
}
#endif
