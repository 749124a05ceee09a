// The line that a chapter prints about each picture.
#include <doctest.h>

#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include "support/running.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap::test;

namespace {

struct Line {
  std::string file;
  double total = 0, load = 0, render = 0, encode = 0, write = 0, rays = 0;
};

/// The lines of an output that has nothing else: no byte before, between or behind them.
std::vector<Line> lines_of(const std::string& text) {
  static const std::regex form(
      "(.*): 40 x 30 pixels, (\\d+\\.\\d) ms \\(load (\\d+\\.\\d), render (\\d+\\.\\d), encode "
      "(\\d+\\.\\d), write (\\d+\\.\\d)\\), (\\d+\\.\\d) million rays/s");
  std::vector<Line> lines;
  std::size_t start = 0;
  while (start < text.size()) {
    const std::size_t end = text.find('\n', start);
    REQUIRE(end != std::string::npos);
    const std::string line = text.substr(start, end - start);
    std::smatch part;
    CAPTURE(line);
    REQUIRE(std::regex_match(line, part, form));
    const auto number = [&](std::size_t i) { return std::stod(part[i].str()); };
    lines.push_back(
        {part[1].str(), number(2), number(3), number(4), number(5), number(6), number(7)});
    start = end + 1;
  }
  return lines;
}

}  // namespace

TEST_CASE("the milliseconds of a picture are the sum of loading, rendering, encoding and writing") {
  const TemporaryFolder folder;
  const std::string command =
      "\"" TEXMAP_CHAPTER "\" --width 40 --height 30 --samples 256 --texture \"" TEXMAP_ASSETS_DIR
      "/earth.png\" --out ";
  const Outcome outcome = run(command + "\"" + (folder / "picture.png") + "\"");
  REQUIRE(outcome.status == 0);
  const std::vector<Line> lines = lines_of(outcome.out);
  REQUIRE(lines.size() == 1);
  const Line& line = lines[0];
  CHECK(line.file == folder / "picture.png");
  CHECK(std::fabs(line.total - (line.load + line.render + line.encode + line.write)) <
        0.251);          // five numbers rounded to tenths
  CHECK(line.load > 1);  // two million texels
  // Rays a second refer to rendering alone.
  const double rays = 40 * 30 * 256 / 1000.0;
  CHECK(line.rays >= rays / (line.render + 0.051) - 0.051);
  CHECK(line.rays <= rays / (line.render - 0.051) + 0.051);
  // Loading counts for the first of several pictures only; a quiet chapter prints no line.
  const std::string turn = command + "\"" + (folder / "turn.png") + "\" --samples 1 --turntable 2";
  const std::vector<Line> both = lines_of(run(turn).out);
  REQUIRE(both.size() == 2);
  CHECK(both[0].load > 1);
  CHECK(both[1].load == 0);
  CHECK(run(turn + " --quiet").out.empty());
}

TEST_CASE("what a chapter prints is its text to the byte, and ends with one end of a line") {
  const Outcome version = run("\"" TEXMAP_CHAPTER "\" --version");
  CHECK(version.status == 0);
  CHECK(version.out == "05_y_rotation " TEXMAP_VERSION " (Texture Mapping, Step by Step)\n");
  CHECK(version.err == "");
  const Outcome help = run("\"" TEXMAP_CHAPTER "\" --help");
  const std::string end =
      "\nexit status: 0 the picture is written; 1 an error, no picture; 2 the command line is "
      "wrong\n";
  CHECK(help.status == 0);
  CHECK(help.out.starts_with("05_y_rotation: "));
  REQUIRE(help.out.find(end) != std::string::npos);
  CHECK(help.out.find(end) + end.size() == help.out.size());
  CHECK(help.err == "");
}

TEST_CASE("what a chapter says of an error is its text to the byte, on stderr alone") {
  const Outcome wrong = run("\"" TEXMAP_CHAPTER "\" --nonsense");
  CHECK(wrong.status == 2);
  CHECK(wrong.out == "");
  CHECK(wrong.err ==
        "error: there is no option --nonsense\nusage: 05_y_rotation [options]     (05_y_rotation "
        "--help lists them)\n");
  const Outcome missing = run("\"" TEXMAP_CHAPTER "\" --texture no/such/file.png --out x.png");
  CHECK(missing.status == 1);
  CHECK(missing.out == "");
  CHECK(missing.err == "error: cannot load texture 'no/such/file.png': there is no such file\n");
}
