// What run_chapter refuses of a lesson and of its user.
#include <doctest.h>

#include "02_checkerboard_uv/lesson.hpp"
#include "engine/run/run_chapter.hpp"
#include "scene/phong.hpp"
#include "support/temporary_folder.hpp"
#include "texture/shape_mappings.hpp"

using namespace texmap;

namespace {

template <class Lesson = chapter_02::Lesson>
int status_of(const std::string& file) {
  const char* const arguments[] = {"stripes",  "--quiet", "--width", "8",
                                   "--height", "6",       "--out",   file.c_str()};
  return run_chapter<Lesson>("stripes", 8, arguments);
}

struct Convex : Cylinder {  // as if copied from a rectangle
  [[nodiscard]] static constexpr bool convex() { return true; }
};
struct Ball : Sphere<> {};
double distance_to(const Ball& ball, const Ray<double>& ray) {
  return distance_to(static_cast<const Sphere<>&>(ball), ray);
}
Hit<double> hit_at(const Ball& ball, const Ray<double>& ray, double distance) {
  return hit_at(static_cast<const Sphere<>&>(ball), ray, distance);
}

using Picture = Mapped<RtiowMapping, Checkerboard>;
using Label = Mapped<CylinderMapping, Checkerboard>;
using Paint = AnyOf<Solid, Picture, Label>;
using AShape = AnyShape<Sphere<>, Cylinder, Rectangle, Convex, Ball>;

/// A globe with a picture, and a second object, seen from above.
struct SecondLesson : LessonHooks {
  static constexpr About about{.idea = "a second object", .numbers = Numbers::only_double};
  Stage stage{.light = {{5, 5, 5}}, .camera = {.eye = {0, 4, 6}, .target = {0, 0, 0}}};
  std::vector<Shiny<Paint, AShape>> objects = {{Sphere<>{{9, 0, 0}, 1}, Picture{}},
                                               {Cylinder{}, Picture{}}};
  Color<double> operator()(const Ray<double>& ray) const { return stage.sky(ray); }
};
std::string refusal_of(const AShape& shape, const Paint& paint) {
  SecondLesson lesson;
  lesson.objects[1] = {shape, paint};
  try {
    check_objects(lesson.objects, lesson.stage.camera);
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a name that promises another kind of picture is refused") {
  const test::TemporaryFolder folder;
  for (const char* name : {"x.jpg", "x.jpeg", "x.gif", "x.bmp", "x.webp"})
    CHECK(status_of(folder / name) == 2);
  CHECK(folder.size() == 0);
  CHECK(status_of(folder / "jpg") == 0);
}

TEST_CASE("a picture that normals place is refused on a can; so is a can that says it is convex") {
  const std::string by_normals = "object 1: its picture is placed by its normals";
  CHECK(refusal_of(Cylinder{}, Picture{}).starts_with(by_normals));
  CHECK(refusal_of(Rectangle{}, Picture{}).starts_with(by_normals));
  CHECK(refusal_of(Convex{}, Label{}).starts_with("object 1: convex() is true"));
  CHECK(refusal_of(Cylinder{}, Label{}).empty());
  CHECK(refusal_of(Rectangle{.up = {0, 1, 1}}, Solid{}).empty());
  CHECK(refusal_of(Ball{}, Picture{}).empty());
  const test::TemporaryFolder folder;
  CHECK(status_of<SecondLesson>(folder / "can.png") == 1);
  CHECK(folder.size() == 0);
}
