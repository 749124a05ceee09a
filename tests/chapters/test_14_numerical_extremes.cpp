// Chapter 14: what it calls broken is broken, what it calls right is right, and its reference has
// enough digits.
#include <doctest.h>

#include "14_numerical_extremes/exhibits.hpp"
#include "14_numerical_extremes/lesson.hpp"
#include "support/many_digits.hpp"
#include "support/pictures.hpp"
#include "support/running.hpp"
#include "support/shown_values.hpp"
#include "support/temporary_folder.hpp"

#ifdef TEXMAP_HAVE_DIGITS
#include "extremes/digits.hpp"

template <>
inline texmap::test::Digits50 texmap::pi<texmap::test::Digits50>() {
  return texmap::extremes::circle<texmap::test::Digits50>();
}
#endif

using namespace texmap;
using namespace texmap::chapter_14;

namespace {

/// A session without an option, for as long as it lives.
struct Alone {
  CommandLine line{"test", ""};
  Chosen chosen{"test", Offer{.line = line}, Lesson::about};
  Session session{chosen};
};

/// The sheet as the program draws it.
const Sheet& sheet() {
  static const Sheet drawn = [] {
    Alone alone;
    return draw_sheet(Lesson{}.exhibits(), alone.session);
  }();
  return drawn;
}

std::vector<std::string> names() {
  std::vector<std::string> listed;
  for (const Exhibit& exhibit : Lesson{}.exhibits()) listed.push_back(exhibit.name);
  return listed;
}

Mistakes mistakes(const std::string& name, Variant variant) {
  static const auto all = names();
  const auto at = std::find(all.begin(), all.end(), name);
  REQUIRE_MESSAGE(bool{at != all.end()}, name);
  return sheet().mistakes[static_cast<std::size_t>(at - all.begin())][variant];
}

/// An exhibit as the program draws it alone, in the size of the sheet's pictures.
Image drawn(const std::string& name, Formulas formulas, NumberKind number) {
  Alone alone;
  alone.chosen.settings.width = 202;
  alone.chosen.settings.height = 149;
  alone.chosen.settings.number = number;
  return draw_exhibit(Lesson{}.exhibits(), name, formulas, alone.session);
}

}  // namespace

TEST_CASE("the course's formulas miss nothing in any exhibit, and no pixel in double is wrong") {
  for (const std::string& name : names()) {
    CAPTURE(name);
    CHECK(mistakes(name, robust_double).wrong == 0);
    CHECK(mistakes(name, robust_double).missed == 0);
    CHECK(static_cast<double>(mistakes(name, robust_double).texels) <= 1e-10);
    const bool textured = mistakes(name, published_float).texels > Judge(0);
    CHECK((mistakes(name, robust_double).texels > Judge(0)) == textured);  // the judge sees more
    CHECK(mistakes(name, robust_float).wrong <=
          8);  // of 30,000: edges that pass within a rounding of a pixel's center
    CHECK(mistakes(name, robust_float).missed == 0);
    CHECK(static_cast<double>(mistakes(name, robust_float).texels) <= 0.1);
  }
}

TEST_CASE("the published formulas break where the chapter says they do") {
  struct Case {
    const char* name;
    int in_float;            // so many pixels are wrong, or more
    bool in_double = false;  // too: more digits cure rounding, and not a wrong bound or sign
  };
  const std::vector<Case> cases = {
      {"from-1e3", 3000},       {"from-1e5", 20000},   {"from-1e7", 20000, true},
      {"pole", 2000},           {"seam", 500},         {"far-home", 1000},
      {"units", 20000},         {"acne", 300},         {"small", 10000, true},
      {"needle", 5000},         {"turns", 10000},      {"highlight", 300, true},
      {"far-floor", 5000},      {"cracks", 200, true}, {"map-middle", 3000},
      {"footprint", 600, true}, {"mirror", 600, true}, {"one-row", 8000, true},
      {"no-number", 6000, true}};
  CHECK(cases.size() + 1 == names().size());  // from-10 is near enough for them
  for (const Case& each : cases) {
    CAPTURE(each.name);
    CHECK(mistakes(each.name, published_float).wrong >= each.in_float);
    CHECK((mistakes(each.name, published_double).wrong > 100) == each.in_double);
  }
}

TEST_CASE("the table of the chapter's page is the one that its program prints, by either judge") {
  CHECK(sheet().table.ends_with(judge_line()));
  if (judge_is_pair) return;
  const std::string page =
      test::text_in(TEXMAP_TESTS_DIR "/../chapters/14_numerical_extremes/README.md");
  const std::string figures = sheet().table.substr(0, sheet().table.find("judge:"));
  CHECK(page.find(figures + "judge: long double, 64 bits\n") != std::string::npos);
}

#ifdef TEXMAP_HAVE_DIGITS
namespace {

using Fifty = test::Digits50;

/// In how many of the sampled pixels the reference differs from fifty digits.
template <class Scene>
int differing_pixels(const Scene& exhibit) {
  const View<> view = view_of(exhibit.camera, 200, 150);
  int wrong = 0;
  for (int i = 0; i < 120; ++i) {
    const int column = i * 37 % view.width;
    const int row = i * 59 % view.height;
    const SurfacePoint<Judge> seen =
        exhibit(ray_through(view, Judge(column), Judge(row)), Formulas::robust);
    const SurfacePoint<Fifty> truth =
        exhibit(ray_through(view, Fifty(column), Fifty(row)), Formulas::robust);
    const auto differ = [](const Judge& a, const Fifty& b) {
      const auto most = static_cast<double>(a);
      const auto rest = static_cast<double>(a - Judge(most));
      return abs(Fifty(most) + Fifty(rest) - b) > Fifty(1e-17);
    };
    const bool same_color =
        !differ(seen.color.r, truth.color.r) && !differ(seen.color.g, truth.color.g);
    const bool same_place =
        !truth.mapped || (!differ(seen.uv.v, truth.uv.v) &&
                          !differ(seen.uv.u * seen.round, truth.uv.u * truth.round));
    wrong += seen.hit == truth.hit && same_color && same_place ? 0 : 1;
  }
  return wrong;
}

}  // namespace

TEST_CASE("the reference of every exhibit, in Judge, sees what fifty digits see") {
  const auto check = [](const auto& exhibit) {
    CAPTURE(exhibit.name);
    CHECK(differing_pixels(exhibit) == 0);
  };
  std::apply([&](const auto&... each) { (check(each), ...); },
             exhibit_scenes(Lesson{}.texture.load(), Lesson{}.labels.load()));
}
#endif

TEST_CASE("no-number: published formulas differ in NaN alone, and the course's have no NaN") {
  const Image published = drawn("no-number", Formulas::published, NumberKind::double_);
  const Image robust = drawn("no-number", Formulas::robust, NumberKind::double_);
  const Rgb8 magenta{255, 0, 255};
  int without_number = 0;
  for (std::size_t i = 0; i < robust.pixels.size(); ++i) {
    CHECK(robust.pixels[i] != magenta);
    if (published.pixels[i] == magenta) {
      ++without_number;
    } else {
      REQUIRE(published.pixels[i] == robust.pixels[i]);
    }
  }
  CHECK(without_number == mistakes("no-number", published_double).wrong);
}

TEST_CASE("an exhibit drawn alone is the one of the sheet, with the number that was chosen") {
  const Image pole = drawn("pole", Formulas::robust, NumberKind::double_);
  const auto wrong_in = [&pole](NumberKind number) {
    return test::count_different(pole, drawn("pole", Formulas::published, number), 1);
  };
  CHECK(wrong_in(NumberKind::double_) == 0);
  CHECK(wrong_in(NumberKind::float_) == mistakes("pole", published_float).wrong);

  const Image extended = drawn("from-1e7", Formulas::published, NumberKind::extended);
  const auto differs = [&extended](Formulas formulas, NumberKind number) {
    return test::count_different(drawn("from-1e7", formulas, number), extended, 1);
  };
  CHECK(differs(Formulas::published, NumberKind::double_) > 1000);
  CHECK(differs(Formulas::robust, NumberKind::extended) < 100);
}

TEST_CASE("a wrong name is told the right ones, and so is who asks for help") {
  const test::Outcome wrong = test::run("\"" TEXMAP_CHAPTER "\" --exhibit equator");
  CHECK(wrong.status == 2);
  const std::string help = test::run("\"" TEXMAP_CHAPTER "\" --help").out;
  for (const std::string& name : names()) {
    CHECK(wrong.err.find(name) != std::string::npos);
    CHECK(help.find(name) != std::string::npos);
  }
}

TEST_CASE("what only one exhibit has a use for is refused for the sheet, and its help says so") {
  const std::string help = test::run("\"" TEXMAP_CHAPTER "\" --help").out;
  for (const std::string option : {"--number float", "--samples 2", "--formulas published"}) {
    CAPTURE(option);
    const test::TemporaryFolder folder;
    const test::Outcome outcome =
        test::run("\"" TEXMAP_CHAPTER "\" --quiet --width 20 --height 20 " + option + " --out \"" +
                  (folder / "x.png") + "\"");
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find("need --exhibit NAME") != std::string::npos);
    const auto at = help.find("  " + option.substr(0, option.find(' ') + 1));
    REQUIRE(at != std::string::npos);
    const auto next = help.find("\n  --", at);
    CHECK(help.substr(at, next - at).find("with --exhibit: ") != std::string::npos);
  }
}

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
