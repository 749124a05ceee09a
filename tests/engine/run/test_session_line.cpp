// The line that a chapter prints about each picture, and what it refuses to draw.
#include <doctest.h>

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

/// Runs a chapter for a small picture.
Outcome drawn(const std::string& chapter, const std::string& words, const std::string& file) {
  return run("\"" TEXMAP_BIN + chapter + "\" --width 40 --height 30 --out \"" + file + "\" " +
             words);
}

}  // namespace

TEST_CASE("the milliseconds of a picture are the sum of loading, rendering, encoding and writing") {
  const TemporaryFolder folder;
  const std::string chapter = "05_y_rotation";
  const std::string words = "--samples 256 --texture \"" TEXMAP_ASSETS_DIR "/earth.png\" ";
  const Outcome outcome = drawn(chapter, words, folder / "picture.png");
  REQUIRE(outcome.status == 0);
  const std::vector<double> of = numbers_of(outcome.out, folder / "picture.png");
  CHECK(std::fabs(of[0] - (of[1] + of[2] + of[3] + of[4])) < 0.251);  // five rounded to tenths
  CHECK(of[1] > 1);                                                   // two million texels
  // Rays a second refer to rendering alone.
  const double rays = 40 * 30 * 256 / 1000.0;
  CHECK(of[5] >= rays / (of[2] + 0.051) - 0.051);
  CHECK(of[5] <= rays / (of[2] - 0.051) + 0.051);
  // Loading counts for the first of several pictures only; a quiet chapter prints no line.
  const std::string turn = words + "--samples 1 --turntable 2 ";
  const std::string both = drawn(chapter, turn, folder / "turn.png").out;
  const std::size_t second = both.find('\n') + 1;
  CHECK(numbers_of(both.substr(0, second), folder / "turn_000.png")[1] > 1);
  CHECK(numbers_of(both.substr(second), folder / "turn_001.png")[1] == 0);
  CHECK(drawn(chapter, turn + "--quiet", folder / "turn.png").out.empty());
#ifdef __linux__  // a device has no neighbors: each picture goes into it
  const std::string device = drawn(chapter, turn, "/dev/null").out;
  CHECK(device.find("/dev/null: 40") != device.rfind("/dev/null: 40"));
  for (const char* name : {"/dev/stdout", "/proc/self/fd/1"}) {  // a file here: pictures alone
    const std::string pictures = drawn(chapter, turn, name).out;
    CHECK(pictures.starts_with("\x89PNG"));
    CHECK(pictures.rfind("\x89PNG") > 0);
    CHECK(pictures.ends_with("IEND\xae\x42\x60\x82"));
  }
#endif
}

TEST_CASE("a size that the scene enlarges is refused as a typed one is") {
  const TemporaryFolder folder;
  const Outcome outcome = run("\"" TEXMAP_BIN
                              "06_phong_texture_blend\" --scene lecture --width "
                              "16384 --out \"" +
                              (folder / "picture.png") + "\"");
  CHECK(outcome.err.starts_with("error: --width 16384 times --height 8192 must be at most"));
  CHECK(outcome.status == 2);
}

TEST_CASE("a close-up and a picture of surfaces refuse what they cannot draw, and write no file") {
  struct Refused {
    const char *chapter, *words;
    std::string says;
  };
  const std::string no_camera =
      "--zoom and --show normal, uv and object work only for pictures that a camera sees; this "
      "picture has no camera";
  for (const Refused& row : std::vector<Refused>{
           {"05_y_rotation", "--zoom 0.009",
            "--zoom takes a number from 0.01 to 1e+06, not '0.009'"},
           {"05_y_rotation", "--zoom 2 --at 20", "--at takes COLUMN,ROW such as 400,300, not '20'"},
           {"05_y_rotation", "--zoom 2 --at 40,0",
            "the column of --at takes a whole number from 0 to 39, not '40'"},
           {"05_y_rotation", "--zoom 2 --at 1,2,3",
            "the row of --at takes a whole number from 0 to 29, not '2,3'"},
           {"05_y_rotation", "--at 1,2",
            "--at is the pixel that stays in its place under --zoom: give --zoom, too"},
           {"05_y_rotation", "--show normal --samples 4",
            "--show normal, uv and object use 1 ray per pixel, because a mean of normals or "
            "objects has no meaning: leave --samples out"},
           {"07_earth_by_sampling", "--show uv --time-limit 1",
            "--time-limit is for colors: leave it out, or --show"},
           {"11_bump_and_normal_maps", "--zoom 2 --show daily", no_camera},
           {"11_bump_and_normal_maps", "--show daily --show uv", no_camera},
           {"11_bump_and_normal_maps", "--green down",
            "--green says how to read a normal map: give --normals FILE, too"},
           {"11_bump_and_normal_maps", "--normals bricks_normals.png --relief 1",
            "--normals has no heights: leave out --relief"},
           {"11_bump_and_normal_maps", "--normals bricks_normals.png --show poles",
            "--normals is for the globe: leave out --show"},
           {"11_bump_and_normal_maps", "--step 0.1",
            "--step is for differences: give --slopes forward or central, too"},
           {"11_bump_and_normal_maps", "--relief-from uv --relief-image earth_relief.png",
            "--relief-from has its heights from waves: leave out --relief-image"},
           {"11_bump_and_normal_maps", "--show sheet --texture earth.png",
            "--texture is for the globe: leave out --show"},
           {"10_projections", "--to cube --projection plane",
            "--to saves a file, and --projection draws the globe: leave one of them out"},
           {"11_bump_and_normal_maps", "--normals earth_relief.png",
            "--normals earth_relief.png: all its texels are gray; it looks like heights: use "
            "--relief-image"},
           {"11_bump_and_normal_maps", "--normals crate.png",
            "--normals crate.png: most of its normals point inward (blue below 128), so it "
            "is no normal map. If it has heights, give it to --relief-image"},
#ifdef TEXMAP_ALL_NUMBERS
           {"06_phong_texture_blend", "--budget levels=1 --highlight lecture",
            "--budget is for Phong's highlight: leave out --highlight lecture"},
           {"07_earth_by_sampling", "--budget levels=4",
            "--budget is for a lone object, which lights no other: add --scene book"},
           {"09_texture_filtering", "--taps 4 --budget levels=4",
            "--budget chooses the filter: leave out --taps or --budget"},
           {"09_texture_filtering", "--zoom 2 --budget levels=4",
            "--budget chooses a filter for the whole picture: leave --zoom out"},
           {"05_y_rotation", "--show uv --number interval",
            "--show normal, uv and object do not work with --number interval, which bounds colors"},
#endif
       }) {
    const TemporaryFolder folder;
    const Outcome outcome = drawn(row.chapter, row.words, folder / "picture.png");
    CAPTURE(outcome.err);
    CHECK(outcome.err.starts_with("error: " + row.says + "\nusage: " + row.chapter));
    CHECK(outcome.status == 2);
    CHECK(folder.size() == 0);
  }
}
