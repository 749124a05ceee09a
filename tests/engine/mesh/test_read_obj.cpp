// Tests of engine/mesh/read_obj.hpp: a file loads whole, or an error names the line.
#include <doctest.h>

#include "engine/mesh/read_obj.hpp"
#include "support/image_errors.hpp"
#include "support/made_meshes.hpp"

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

TEST_CASE("what is no textured triangle is skipped and named once, but no call of another file") {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n";
  std::string skipped = "old";
  CHECK_NOTHROW(static_cast<void>(read_obj("g a\nvn 0 0 1\n" + triangle, &skipped)));
  CHECK(skipped.empty());
  const std::string curved = "p 1\nl 1 2\ncurv2 1 2\ncurv 0 1 1 2\nl 2 3\nend\n";
  CHECK(read_obj(triangle + curved, &skipped).mesh.triangles.size() == 1);
  CHECK(skipped == "p, l, curv2, curv, end");
  CHECK_THROWS_AS(static_cast<void>(read_obj(triangle + "call a.obj\n")), FileError);
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

}  // namespace
}  // namespace texmap::test
