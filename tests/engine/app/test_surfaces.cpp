// Pictures of normals, (u, v) and objects, as --show draws them in every chapter with a camera.
#include "engine/render/surfaces.hpp"

#include <doctest.h>

#include "02_checkerboard_uv/lesson.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "07_earth_by_sampling/lesson.hpp"
#include "08_triangle_uv/lesson.hpp"
#include "08_triangle_uv/surface.hpp"
#include "09_texture_filtering/lesson.hpp"
#include "09_texture_filtering/surface.hpp"
#include "11_bump_and_normal_maps/lesson.hpp"
#include "11_bump_and_normal_maps/surface.hpp"
#include "12_environment_map/lesson.hpp"
#include "support/pictures.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

template <class Lesson>
Image shown(const Lesson& lesson, Shown what) {
  return draw_surfaces(lesson, view_of(lesson.stage.camera, 203, 151), what, NumberKind::double_,
                       {.samples = 16});
}

Rgb8 bytes(const Rgb& c) { return {byte_of(c.r), byte_of(c.g), byte_of(c.b)}; }

template <class Lesson>
void check_objects(const Lesson& lesson) {
  CAPTURE(Lesson::about.idea);
  const Image picture = shown(lesson, Shown::object);
  const std::vector<int> seen = objects_seen(lesson, picture.width, picture.height);
  std::vector<long> pixels(lesson.objects.size() + 1);
  long wrong = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto object = static_cast<std::size_t>(seen[i] + 1);
    ++pixels[object];
    const Rgb8 expected = object == 0 ? Rgb8{} : bytes(object_colors[object - 1]);
    wrong += picture.pixels[i] == expected ? 0 : 1;
  }
  CHECK(wrong == 0);
  for (const long count : pixels) CHECK(count > 30);
}

}  // namespace

TEST_CASE("the six axes have their normals and their (u, v), to the byte") {
  struct Axis {
    Vec3d to;
    Rgb8 normal, uv;
  };
  // Bytes are cut off: 1/4 is 63, 1/2 is 127, 3/4 is 191.
  for (const Axis& axis : {Axis{{1, 0, 0}, {255, 127, 127}, {127, 127, 0}},
                           Axis{{-1, 0, 0}, {0, 127, 127}, {0, 127, 0}},
                           Axis{{0, 1, 0}, {127, 255, 127}, {127, 255, 0}},
                           Axis{{0, -1, 0}, {127, 0, 127}, {127, 0, 0}},
                           Axis{{0, 0, 1}, {127, 127, 255}, {63, 127, 0}},
                           Axis{{0, 0, -1}, {127, 127, 0}, {191, 127, 0}}}) {
    const Ray<double> ray{axis.to * 3.0, -axis.to};
    const auto color = [&](Shown what) {
      auto lesson = prepared<chapter_04::Lesson>({"--convention", "rtiow"});
      lesson.objects = {lesson.objects[chapter_04::middle]};
      return bytes(SurfaceColors<chapter_04::Lesson>{lesson, what}(ray));
    };
    CAPTURE(axis.to);
    CHECK(color(Shown::normal) == axis.normal);
    CHECK(color(Shown::uv) == axis.uv);
    CHECK(color(Shown::object) == bytes(object_colors[0]));
  }
}

TEST_CASE("every pixel has the color of the object that is seen there, and all objects are seen") {
  check_objects(chapter_02::Lesson{});
  check_objects(prepared<chapter_05::Lesson>());
  check_objects(prepared<chapter_07::Lesson>());
  check_objects(prepared<chapter_12::Lesson>());
}

TEST_CASE("of a mesh each triangle is an object, and its (u, v) are those of its corners") {
  const auto lesson = prepared<chapter_08::Lesson>();
  const auto& mesh = lesson.scene.mesh;
  int seen = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = corners_of(mesh, static_cast<double>(i));
    const Vec3d normal = normalize(cross(b - a, c - a));
    const Vec3d near_a = a * 0.999 + b * 0.0005 + c * 0.0005;
    const auto surface = surface_along(lesson, Ray<double>{near_a + normal * 1e-3, -normal});
    if (surface.object != static_cast<int>(i)) continue;  // the floor under the crate
    ++seen;
    const Uv<double> corner = lesson.scene.mapping.corners[i][0];
    CHECK(std::abs(surface.uv.u - corner.u) < 0.01);
    CHECK(std::abs(surface.uv.v - corner.v) < 0.01);
    CHECK(length(surface.normal - normal) < 1e-12);
  }
  CHECK(seen >= 10);
  CHECK(surface_along(lesson, Ray<double>{{0, 9, 0}, {0, 1, 0}}).object == -1);
}

TEST_CASE("the floor is an object behind all others, with (u, v) that repeat") {
  const auto lesson = prepared<chapter_09::Lesson>();
  const auto below = surface_along(lesson, Ray<double>{{0, 5, 0}, {0, -1, 0}});
  CHECK(below.object == 2);
  CHECK(below.normal.y == 1);
  CHECK(bytes(color_of_surface(below, Shown::uv)) == Rgb8{127, 0, 0});
  Surface<double> beyond = below;
  beyond.uv = {3.25, -1.25};  // an eighth copy shows what the first does
  CHECK(bytes(color_of_surface(beyond, Shown::uv)) == Rgb8{63, 191, 0});
}

TEST_CASE("normals lean with the bumps, and not without them") {
  const auto normals = [](const std::vector<std::string>& words) {
    return shown(prepared<chapter_11::Lesson>(words), Shown::normal);
  };
  const Image flat = normals({"--bump", "off"});
  CHECK(count_different(normals({}), flat, 4) > 1000);
  chapter_11::Lesson plain;
  plain.bumps.form = BumpForm::flat;
  CHECK(shown(plain, Shown::normal) == flat);
}
