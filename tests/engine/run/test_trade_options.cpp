// --trade and --extremes of a chapter's program, on small pictures.
#include <doctest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "support/running.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap::test;

namespace {

Outcome measured(const std::string& chapter, const std::string& words, const std::string& file) {
  return run("\"" TEXMAP_BIN + chapter + "\" --width 24 --height 18 --out \"" + file + "\" " +
             words);
}

/// The cells of the line that begins so, without the beginning.
std::vector<std::string> row_of(const std::string& text, const std::string& begin) {
  std::smatch line;
  REQUIRE_MESSAGE(std::regex_search(text, line, std::regex("(^|\n) *" + begin + " +([^\n]*)")),
                  text);
  std::vector<std::string> cells;
  const std::string rest = line[2];
  static const std::regex word("at once|[^ ]+");
  for (std::sregex_iterator cell(rest.begin(), rest.end(), word), end; cell != end; ++cell)
    cells.push_back(cell->str());
  return cells;
}

}  // namespace

TEST_CASE("--trade measures what the program offers and the user did not choose") {
  const TemporaryFolder folder;
  const Outcome outcome = measured("06_phong_texture_blend", "--trade", folder / "a.png");
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  // Packs of double draw what double draws; of the columns the third has the pixels.
  CHECK(row_of(outcome.out, "--number double-pack --instructions baseline").at(2) == "0");
  CHECK(row_of(outcome.out, "--number double --spheres hybrid").size() == 5);
  CHECK(row_of(outcome.out, "--budget levels=1").size() == 5);
  CHECK(std::stod(row_of(outcome.out, "--samples 4").at(4)) <
        std::stod(row_of(outcome.out, "--samples 1").at(4)));
  CHECK(folder.size() == 1);  // a_trade.svg, and no picture

  const std::string chosen =
      measured("06_phong_texture_blend", "--number float --samples 3 --trade", folder / "a.png")
          .out;
  CHECK_FALSE(has(chosen, "double"));
  CHECK(has(chosen, "./course run 06 --width 24 --height 18 --number float"));
  CHECK(row_of(chosen, "as typed").at(2) == "0");
  CHECK(row_of(chosen, "--samples 3").size() == 5);
  CHECK(has(measured("01_plain_spheres", "--trade", folder / "b.png").out, "No --budget: "));
  CHECK(measured("07_earth_by_sampling", "--trade --samples 1 --budget=levels=4", folder / "b.png")
            .err.starts_with("error: --budget is for a lone object"));
  CHECK(measured("07_earth_by_sampling", "--trade --time-limit 1", folder / "b.png")
            .err.starts_with("error: --time-limit stops a slow way"));
  CHECK(measured("01_plain_spheres", "--trade --number interval", folder / "b.png").status == 2);
  const std::string gathered =
      measured("12_environment_map", "--trade --samples 1", folder / "b.png").out;
  for (const char* row : {"--sampler random", "--light mis", "--samples 4"})
    CHECK(row_of(gathered, row).size() == 5);
  const std::string one = "\n  --samples 1 ";
  CHECK(gathered.find(one) == gathered.rfind(one));
  CHECK(measured("10_projections", "--trade --to cube", folder / "b.png")
            .err.find("leave out --to") != std::string::npos);
  CHECK(measured("01_plain_spheres", "--trade --show normal", folder / "b.png").status == 2);
  const std::string file = folder / "my earth.png";
  std::filesystem::copy_file(TEXMAP_ASSETS_DIR "/earth.png", file);
  CHECK(has(measured("06_phong_texture_blend", "--trade --number float --texture \"" + file + "\"",
                     folder / "b.png")
                .out,
            " --texture '" + file + "'"));
}

TEST_CASE("in double a scene may have any size, and lie a million radii away") {
  const TemporaryFolder folder;
  for (const char* chapter :
       {"01_plain_spheres", "07_earth_by_sampling", "08_triangle_uv", "09_texture_filtering"}) {
    const Outcome outcome = measured(chapter, "--extremes --samples 1", folder / "a.png");
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    const std::vector<std::string> never = {"never", "never", "never"};
    CHECK(row_of(outcome.out, "double everything smaller") == never);
    CHECK(row_of(outcome.out, "double everything larger") == never);
    const auto moved = row_of(outcome.out, "double everything moved by");
    REQUIRE(moved.at(0) != "at once");
    CHECK(std::stod(moved.at(0)) >= 1e6);
    CHECK(std::stod(moved.at(2)) < 1e20);  // where neighboring doubles are farther apart than balls
    CHECK(row_of(outcome.out, "float  everything moved by").at(2) != "never");
  }
  CHECK(measured("01_plain_spheres", "--extremes --number float", folder / "a.png").status == 2);
  CHECK(measured("09_texture_filtering", "--extremes --plot x.svg", folder / "a.png").status == 2);
  CHECK(measured("07_earth_by_sampling", "--extremes --time-limit 1", folder / "a.png").status ==
        2);
  CHECK(folder.size() == 0);
}
