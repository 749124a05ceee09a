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

std::vector<Line> lines_of(const std::string& text) {
  const std::regex form(
      "(.*): 40 x 30 pixels, (\\d+\\.\\d) ms \\(load (\\d+\\.\\d), render (\\d+\\.\\d), encode "
      "(\\d+\\.\\d), write "
      "(\\d+\\.\\d)\\), "
      "(\\d+\\.\\d) million rays/s\n");
  std::vector<Line> lines;
  for (std::sregex_iterator at(text.begin(), text.end(), form), end; at != end; ++at) {
    const auto number = [&](int i) { return std::stod((*at)[static_cast<std::size_t>(i)].str()); };
    lines.push_back(
        {(*at)[1].str(), number(2), number(3), number(4), number(5), number(6), number(7)});
  }
  return lines;
}

}  // namespace

TEST_CASE("the milliseconds of a picture are the sum of loading, rendering, encoding and writing") {
  const TemporaryFolder folder;
  const std::string command = TEXMAP_CHAPTER
      " --width 40 --height 30 --samples 256 --texture " TEXMAP_ASSETS_DIR "/earth.png --out ";
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
}

TEST_CASE("loading counts for the first of several pictures only") {
  const TemporaryFolder folder;
  const std::string command = TEXMAP_CHAPTER
      " --width 40 --height 30 --turntable 3 --texture " TEXMAP_ASSETS_DIR "/earth.png --out ";
  const std::vector<Line> lines = lines_of(run(command + "\"" + (folder / "turn.png") + "\"").out);
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].load > 1);
  CHECK(lines[1].load == 0);
  CHECK(lines[2].load == 0);
}

TEST_CASE("a quiet chapter prints no line") {
  const TemporaryFolder folder;
  const std::string command = TEXMAP_CHAPTER
      " --quiet --width 40 --height 30 --texture " TEXMAP_ASSETS_DIR "/earth.png --out ";
  CHECK(run(command + "\"" + (folder / "picture.png") + "\"").out == "");
}
