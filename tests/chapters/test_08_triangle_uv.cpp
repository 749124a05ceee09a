// Chapter 08: texture coordinates in the corners of triangles.
#include <doctest.h>

#include <fstream>

#include "08_triangle_uv/lesson.hpp"
#include "number/kinds/pack2.hpp"
#include "scene/floor.hpp"
#include "support/lesson_laws.hpp"
#include "support/same_picture.hpp"
#include "support/shown_values.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap;
using namespace texmap::test;
using chapter_08::Lesson;

namespace {

constexpr int width = Lesson::about.size.width;
constexpr int height = Lesson::about.size.height;

Image drawn(const std::vector<std::string>& words) {
  return picture(prepared<Lesson>(words), width, height);
}

/// The triangle that each pixel shows, -1 for the sky.
std::vector<int> triangles_seen(const Lesson& lesson) {
  std::vector<int> seen;
  for_each_ray(view_of(lesson.stage.camera, width, height), [&](const Ray<double>& ray) {
    const auto hit = first_hit(lesson.scene.mesh, ray);
    seen.push_back(hit.met ? static_cast<int>(hit.triangle) : -1);
  });
  return seen;
}

}  // namespace

TEST_CASE("all numbers draw one picture; float differs at edges of texels and of the crate" *
          NeedsPacks<Lesson>{}) {
  const Lesson lesson = prepared<Lesson>();
  const auto in = [&]<class Real>(Real) { return picture<Real>(lesson, 482, 361); };
  const Image reference = in(1.0);
  const Image in_float = in(1.0F);
  expect_same_picture(in(1.0L), reference);
  expect_same_picture(in(Pack<double>(1)), reference);
  expect_same_picture(in(Pack2<Pack<double>>(1)), reference);
  CHECK(in(Pack2<Pack<float>>(1)) == in_float);
  CHECK(count_different(in_float, reference) > 0);
  CHECK(count_different(in_float, reference) < 482 * 361 / 500);
}

TEST_CASE("a quarter turn changes the top of the crate and nothing else") {
  const Lesson lesson = prepared<Lesson>({"--degrees", "0"});
  const Image before = drawn({"--degrees", "0"});
  const Image after = drawn({"--degrees", "90"});
  CHECK(changed_elsewhere(before, after, triangles_seen(lesson), {8, 9}) == 0);
  CHECK(count_different(before, after) > 1000);
  expect_same_picture(drawn({"--degrees", "360"}), before);
  expect_same_picture(drawn({"--degrees", "-3600000"}), before);
  CHECK(count_different(drawn({"--degrees", "1"}), before) > 1000);
}

TEST_CASE("wrapping changes the floor alone: on the crate (u, v) are 0 to 1") {
  const std::vector<int> seen = triangles_seen(prepared<Lesson>());
  const Image mirror = drawn({});
  for (const char* wrap : {"repeat", "clamp", "article"}) {
    const Image other = drawn({"--wrap", wrap});
    CAPTURE(wrap);
    CHECK(changed_elsewhere(mirror, other, seen, {12, 13}) == 0);
    CHECK(count_different(other, mirror) > 20000);
  }
}

TEST_CASE(
    "a texture that mirrors at its edges is the same moved by two copies, or with -u and -v") {
  expect_same_picture(drawn({"--uv-offset", "2,-4"}), drawn({}), {.pixels = 4});
  expect_same_picture(drawn({"--uv-scale", "-1x-1"}), drawn({}), {.pixels = 4});
  CHECK(count_different(drawn({"--uv-offset", "1,0"}), drawn({})) > 20000);
}

TEST_CASE("Heron's weights draw the crate, but for texels at the edge of a pixel") {
  const Image exact = drawn({});
  CHECK(count_different(drawn({"--weights", "heron"}), exact) < 20);
  const auto in_float = [](const char* weights) {
    return picture<float>(prepared<Lesson>({"--weights", weights}), width, height);
  };
  const long lost = count_different(in_float("heron"), in_float("signed"));
  if (draws_in<Lesson, float>) CHECK(lost > 0);
}

TEST_CASE("weights of the picture: half an edge in its middle, and u and v change evenly") {
  Mesh edge;
  edge.points = {{-1, 0, -1}, {3, 0, -3}, {0, 9, -1}};
  edge.triangles = {{0, 1, 2}};
  MeshHit<double> middle;
  middle.met = true;
  middle.triangle = 0;
  std::tie(middle.a, middle.b, middle.c) = std::tuple(0.75, 0.25, 0.0);
  const MeshHit<double> seen =
      published::weighted_in_picture(edge, middle, {.eye = {0, 0, 0}, .target = {0, 0, -7}});
  CHECK((seen.a == 0.5 && seen.b == 0.5 && seen.c == 0));

  const Lesson lesson = prepared<Lesson>({"--weights", "picture"});
  const View<> view = view_of(lesson.stage.camera, width, height);
  const auto at = [&](int column, int row) {
    const auto ray = ray_through(view, double(column), double(row));
    return lesson.choice.weighted(lesson.scene.mesh, first_hit(lesson.scene.mesh, ray));
  };
  long lines = 0;
  for (int row = 0; row < height; row += 10) {
    for (int column = 20; column < width - 20; column += 10) {
      const MeshHit<double> left = at(column - 20, row), here = at(column, row),
                            right = at(column + 20, row);
      if (!left.met || !right.met || left.triangle != right.triangle ||
          left.triangle != here.triangle)
        continue;
      const auto uv = [&](const MeshHit<double>& hit) { return lesson.paint.mapping(hit); };
      CHECK(std::abs(uv(left).u + uv(right).u - 2 * uv(here).u) < 1e-10);
      CHECK(std::abs(uv(left).v + uv(right).v - 2 * uv(here).v) < 1e-10);
      ++lines;
    }
  }
  CHECK(lines > 100);
  const Image wrong = drawn({"--weights", "picture"});
  CHECK(count_different(wrong, drawn({})) > 20000);
}

TEST_CASE("with u = x and v = z in its corners a triangle draws the plane map, pixel for pixel") {
  Lesson lesson = prepared<Lesson>({"--texture", "uv_map.png", "--wrap", "repeat"});
  lesson.scene.mesh = {};
  lesson.scene.mesh.points = {{-4, 0, 3}, {5, 0, 3}, {0.5, 0, -7}};
  lesson.scene.mesh.triangles = {{0, 1, 2}};
  lesson.paint.mapping.mapping.corners = {{{{-4, 3}, {5, 3}, {0.5, -7}}}};
  long met = 0;
  long different = 0;
  for_each_ray(view_of(lesson.stage.camera, width, height), [&](const Ray<double>& ray) {
    const MeshHit<double> hit = first_hit(lesson.scene.mesh, ray);
    if (!hit.met) return;
    const Vec3d point = point_on(Floor{}, ray, distance_to(Floor{}, ray));
    const Rgb expected = lesson.paint.texture(Uv<double>{point.x, point.z});
    const Rgb color = lesson.paint(hit);
    ++met;
    if (color.r != expected.r || color.g != expected.g || color.b != expected.b) ++different;
  });
  CHECK(met > 20000);
  CHECK(different <= 2);  // where 1e-15 lies between two texels
}

TEST_CASE("a mesh from a file is drawn in place of the crate, as large and on the floor") {
  const TemporaryFolder folder;
  const std::string file = folder / "pyramid.obj";
  std::ofstream(file) << "v 100 5 100\nv 140 5 100\nv 140 5 140\nv 100 5 140\nv 120 35 120\n"
                         "v 1e4 -1e4 1e4\n"  // of no face
                         "vt 0 0\nvt 1 0\nvt 0.5 1\n"
                         "f 4/1 3/2 5/3\nf 3/1 2/2 5/3\nf 2/1 1/2 5/3\nf 1/1 4/2 5/3\n";
  const Lesson lesson = prepared<Lesson>({"--mesh", file, "--degrees", "0"});
  CHECK(lesson.scene.mesh.triangles.size() == 6);
  CHECK(lesson.scene.mesh.points[0].x == -1);
  CHECK(lesson.scene.mesh.points[0].y == -1);
  CHECK(lesson.scene.mesh.points[4].y == 0.5);
  CHECK(count_different(picture(lesson, width, height), drawn({"--degrees", "0"})) > 5000);
}

TEST_CASE(
    "a file's picture is repeated unless the user chooses, and normals in corners are mixed") {
  const TemporaryFolder folder;
  const std::string square =
      "v -1 0 0\nv 1 0 0\nv 1 2 0\nv -1 2 0\nvt 0 0\nvt 3 0\nvt 3 3\nvt 0 3\n";
  const auto square_of = [&](const char* name, const char* normals) {
    std::ofstream(folder / name) << square << normals << "f 1/1/1 2/2/2 3/3/2 4/4/1\n";
    return folder / name;
  };
  const std::string own = square_of("own.obj", "vn 0 0 2\nvn 0 0 -1\n");
  const std::string round = square_of("round.obj", "vn -1 0 1\nvn 1 0 1\n");
  const auto of = [&](const std::string& file, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--mesh", file, "--degrees", "0"});
    return prepared<Lesson>(more);
  };
  const auto drawn_of = [](const Lesson& lesson) { return picture(lesson, width, height); };
  const Image plain = drawn_of(of(round, {"--normals", "flat"}));
  expect_same_picture(drawn_of(of(own)), plain);
  expect_same_picture(drawn_of(of(own, {"--wrap", "repeat"})), plain);
  CHECK(count_different(drawn_of(of(own, {"--wrap", "mirror"})), plain) > 5000);
  CHECK(count_different(drawn_of(of(round)), plain) > 5000);

  const Lesson lesson = of(round);
  for (const double side : {1.0, -1.0}) {  // a quarter from the left, seen from both sides
    const Ray<double> ray{{-0.5, 0, 4 * side}, {0, 0, -side}};
    const Vec3d normal = lesson.first_surface(ray).normal;
    CHECK(normal.x == doctest::Approx(-0.5 / std::sqrt(1.25) * side));
    CHECK(normal.z == doctest::Approx(1 / std::sqrt(1.25) * side));
  }
}

TEST_CASE("a mesh has the pictures and colors of its materials; --texture replaces all") {
  const TemporaryFolder folder;
  const std::string file = folder / "m.obj";
  std::ofstream(file) << "mtllib of m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt .1 .2\nf 1/1 2/1 3/1\n"
                         "usemtl lid\nf 1/1 2/1 3/1\nf 1 2 3\nusemtl red\nf 1/1 2/1 3/1\n"
                         "usemtl lost\nf 1/1 2/1 3/1\nf 1 2 3\n";
  std::ofstream(folder / "of m.mtl")
      << "newmtl lid\nKd 0 1 0\nmap_Kd -s 2 1 -o 0 .5 " TEXMAP_ASSETS_DIR
         "/crate.png\nnewmtl red\nKd 1 0 0\n";
  const Lesson lesson = prepared<Lesson>({"--mesh", file});
  const Lesson replaced = prepared<Lesson>({"--mesh", file, "--texture", "crate.png"});
  const auto is = [](const Rgb& color, const Rgb& other) {
    return largest(Vec3d{color.r - other.r, color.g - other.g, color.b - other.b}) == 0;
  };
  const Rgb plain{0.8, 0.8, 0.8}, lid = lesson.paint.texture(Uv<double>{0.1, 0.2});
  const Rgb colors[] = {lid,  lesson.paint.texture(Uv<double>{0.2, 0.7}), {0, 1, 0}, {1, 0, 0}, lid,
                        plain};
  for (int i = 0; i < 6; ++i) {
    CAPTURE(i);
    MeshHit<double> hit;
    hit.triangle = i;
    CHECK(is(lesson.paint(hit), colors[i]));
    CHECK(is(replaced.paint(hit), i == 2 || i == 5 ? plain : lid));
  }
  MeshHit<Pack<double>> hits;  // each lane has its own material
  hits.triangle = from_lanes<Pack<double>>([](std::size_t i) { return double(i % 6); });
  const auto of_lanes = all_lanes(lesson.paint(hits).r);
  for (std::size_t i = 0; i < of_lanes.size(); ++i) CHECK(of_lanes[i] == colors[i % 6].r);
}

TEST_CASE("-clamp on repeats a picture's edge, unless --wrap is given; -mm changes texels") {
  const TemporaryFolder folder;
  const std::string file = folder / "m.obj";
  std::ofstream(file) << "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 1.2 -.3\n"
                         "usemtl clamped\nf 1/1 2/1 3/1\nusemtl repeated\nf 1/1 2/1 3/1\n"
                         "usemtl changed\nf 1/1 2/1 3/1\nusemtl clear\nf 1/1 2/1 3/1\n";
  const std::string crate = TEXMAP_ASSETS_DIR "/crate.png\n";
  std::ofstream(folder / "m.mtl") << "newmtl clamped\nmap_Kd -clamp on " + crate +
                                         "newmtl repeated\nmap_Kd -clamp off " + crate +
                                         "newmtl changed\nmap_Kd -mm 0.9 -0.5 " + crate +
                                         "newmtl clear\nmap_Kd " TEXMAP_TESTS_DIR
                                         "/corpus/png_rgba16_normal.png\n";
  const auto colors_with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--mesh", file});
    const Lesson lesson = prepared<Lesson>(arguments);
    std::array<Vec3d, 4> colors;
    MeshHit<double> hit;
    for (std::size_t i = 0; i < 4; ++i) {
      hit.triangle = double(i);
      const Rgb color = lesson.paint(hit);
      colors[i] = {color.r, color.g, color.b};
    }
    return colors;
  };
  const Lesson crates = prepared<Lesson>({});
  const auto texel = [&](double u, double v) {
    const Rgb color = crates.paint.texture(Uv<double>{u, v});
    return Vec3d{color.r, color.g, color.b};
  };
  const auto [clamped, repeated, changed, clear] = colors_with({});
  CHECK(largest(clamped - texel(1, 0)) == 0);
  CHECK(largest(repeated - texel(0.2, 0.7)) == 0);
  CHECK(largest(clamped - repeated) > 0.05);
  const Vec3d expected = Vec3d{0.9, 0.9, 0.9} - texel(0.2, 0.7) * 0.5;
  CHECK(largest(changed - expected) <= 0.5 / 255 + 1e-12);
  CHECK(largest(clear) == 0);  // over black, as with --texture
  CHECK(largest(colors_with({"--wrap", "repeat"})[0] - repeated) == 0);
}
