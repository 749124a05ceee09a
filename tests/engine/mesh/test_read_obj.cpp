// Tests of engine/mesh/read_obj.hpp: a file loads whole, or an error names the line.
#include <doctest.h>

#include <fstream>

#include "engine/mesh/read_obj.hpp"
#include "support/dice.hpp"
#include "support/image_errors.hpp"
#include "support/made_meshes.hpp"
#include "support/temporary_folder.hpp"

namespace texmap::test {
namespace {

TEST_CASE("every bad file is refused with its line and the reason") {
  CHECK(bad_meshes().size() >= 40);
  for (const BadMesh& bad : bad_meshes()) {
    CAPTURE(bad.name);
    const std::string error = image_error_of([&] { static_cast<void>(read_obj(bad.text)); });
    CHECK(error.substr(0, bad.error.size()) == bad.error);
    CHECK(error.size() < 160);
  }
}

TEST_CASE("good files load, with all points and triangles") {
  for (const GoodMesh& good : good_meshes()) {
    CAPTURE(good.name);
    TexturedMesh mesh;
    CHECK_NOTHROW(mesh = read_obj(good.text));
    CHECK(mesh.mesh.points.size() == good.points);
    CHECK(mesh.mesh.triangles.size() == good.triangles);
    CHECK(mesh.mapping.corners.size() == good.triangles);
  }
}

TEST_CASE("numbers, indices and fans arrive as they are in the file") {
  const TexturedMesh read = read_obj(
      "v 0 0 0\nv 1.5 -2e-3 3\nv 4 5 6\nv 7 8 9\nvt 0.25 0.5\nvt -1 2\n"
      "f 1/1 2/2 3/1 4/2\nf -1/-1/7 -2/-2/7 -3/-1/7\n");
  CHECK(read.mesh.points[1].x == 1.5);
  CHECK(read.mesh.points[1].y == -2e-3);
  CHECK(read.mesh.triangles[0] == std::array{0, 1, 2});
  CHECK(read.mesh.triangles[1] == std::array{0, 2, 3});
  CHECK(read.mesh.triangles[2] == std::array{3, 2, 1});
  CHECK(read.mapping.corners[0][1].u == -1);
  CHECK(read.mapping.corners[1][0].u == 0.25);
  CHECK(read.mapping.corners[2][0].v == 2);
  CHECK(read.mapping.corners[2][1].v == 0.5);
}

TEST_CASE("changed files load or are refused, and what loads has indices and finite numbers") {
  Dice dice;
  int loaded = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = square_points + "f 1/1 2/2 3/3 4/4\nf -1/-1/1 -2/-2/1 -3/-3/1\n";
    for (int change = dice.within(1, 4); change > 0; --change) {
      const auto place = static_cast<std::size_t>(dice.below(static_cast<int>(text.size())));
      constexpr std::string_view likely = "0123456789-+./ \nvtfe#\\";
      text[place] = dice.once_in(8)
                        ? static_cast<char>(dice.below(256))
                        : likely[static_cast<std::size_t>(dice.below(int{likely.size()}))];
    }
    try {
      const TexturedMesh read = read_obj(text);
      ++loaded;
      for (const auto& triangle : read.mesh.triangles) {
        for (const int corner : triangle) {
          REQUIRE(corner >= 0);
          REQUIRE(static_cast<std::size_t>(corner) < read.mesh.points.size());
        }
      }
      for (const Point& p : read.mesh.points) REQUIRE(largest(p) <= max_mesh_number);
    } catch (const FileError& error) {
      REQUIRE(std::string(error.what()).size() > 10);
    }
  }
  CHECK(loaded > 500);
  CHECK(loaded < 19000);
}

TEST_CASE(
    "a file's error names the file and the line; missing files, folders and empty files too") {
  const TemporaryFolder folder;
  const std::filesystem::path inside = folder.path();
  const auto path = inside / "bad.obj";
  const auto error_of = [](const std::filesystem::path& at) {
    return image_error_of([&] { static_cast<void>(load_obj(at)); });
  };
  std::ofstream(path) << "v 0 0 zero\n";
  CHECK(error_of(path) ==
        "cannot load mesh '" + name_of(path) + "': line 1: 'zero' is not a finite decimal number");
  std::ofstream(path, std::ios::trunc).flush();
  CHECK(error_of(path).find("cannot load mesh") == 0);
  CHECK(error_of(inside).find("cannot load mesh") == 0);
  CHECK(error_of(inside / "none.obj").find("cannot load mesh") == 0);
  std::ofstream(path, std::ios::trunc) << square_points << "f 1/1 2/2 3/3\n";
  CHECK(load_obj(path).mesh.triangles.size() == 1);
}

}  // namespace
}  // namespace texmap::test
