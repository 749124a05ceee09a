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

/// The numbers in the only line of an output: total, load, render, encode, write, rays.
std::vector<double> numbers_of(const std::string& line, const std::string& file) {
  static const std::regex form(
      "(.*): 40 x 30 pixels, (\\d+\\.\\d) ms \\(load (\\d+\\.\\d), render (\\d+\\.\\d), encode "
      "(\\d+\\.\\d), write (\\d+\\.\\d)\\), (\\d+\\.\\d) million rays/s\n");
  std::smatch part;
  CAPTURE(line);
  REQUIRE(std::regex_match(line, part, form));
  CHECK(part[1].str() == file);
  std::vector<double> numbers;
  for (std::size_t i = 2; i < part.size(); ++i) numbers.push_back(std::stod(part[i].str()));
  return numbers;
}

}  // namespace

TEST_CASE("the milliseconds of a picture are the sum of loading, rendering, encoding and writing") {
  const TemporaryFolder folder;
  const std::string command =
      "\"" TEXMAP_CHAPTER "\" --width 40 --height 30 --samples 256 --texture \"" TEXMAP_ASSETS_DIR
      "/earth.png\" --out ";
  const Outcome outcome = run(command + "\"" + (folder / "picture.png") + "\"");
  REQUIRE(outcome.status == 0);
  const std::vector<double> of = numbers_of(outcome.out, folder / "picture.png");
  CHECK(std::fabs(of[0] - (of[1] + of[2] + of[3] + of[4])) < 0.251);  // five rounded to tenths
  CHECK(of[1] > 1);                                                   // two million texels
  // Rays a second refer to rendering alone.
  const double rays = 40 * 30 * 256 / 1000.0;
  CHECK(of[5] >= rays / (of[2] + 0.051) - 0.051);
  CHECK(of[5] <= rays / (of[2] - 0.051) + 0.051);
  // Loading counts for the first of several pictures only; a quiet chapter prints no line.
  const std::string turn = command + "\"" + (folder / "turn.png") + "\" --samples 1 --turntable 2";
  const std::string both = run(turn).out;
  const std::size_t second = both.find('\n') + 1;
  CHECK(numbers_of(both.substr(0, second), folder / "turn_000.png")[1] > 1);
  CHECK(numbers_of(both.substr(second), folder / "turn_001.png")[1] == 0);
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
