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

/// The lower half of a sphere, open: its own shadow falls into it.
struct Bowl : Sphere<> {};
double distance_to(const Bowl& bowl, const Ray<double>& ray) {
  const auto& whole = static_cast<const Sphere<>&>(bowl);
  const double near = distance_to(whole, ray);
  if (!(near < infinity<double>()) || ray.origin.y + near * ray.direction.y < bowl.center.y)
    return near;
  const Point inside = ray.origin + ray.direction * (near + 1e-9);
  const double far = near + 1e-9 + distance_to(whole, Ray<double>{inside, ray.direction});
  return ray.origin.y + far * ray.direction.y < bowl.center.y ? far : infinity<double>();
}
Hit<double> hit_at(const Bowl& bowl, const Ray<double>& ray, double distance) {
  Hit<double> hit = hit_at(static_cast<const Sphere<>&>(bowl), ray, distance);
  if (dot(hit.normal, ray.direction) > 0) hit.normal = -hit.normal;
  hit.outside = hit.point + hit.normal * 1e-9;
  return hit;
}
struct HonestBowl : Bowl {
  [[nodiscard]] static constexpr bool convex() { return false; }
};

using Picture = Mapped<RtiowMapping, Checkerboard>;
using Label = Mapped<CylinderMapping, Checkerboard>;
using Paint = AnyOf<Solid, Picture, Label>;
using AShape = AnyShape<Sphere<>, Cylinder, Rectangle, Bowl, HonestBowl>;

/// What check_objects says of an object of this shape and paint behind a globe with a picture.
std::string refusal_of(const AShape& shape, const Paint& paint) {
  const std::vector<Shiny<Paint, AShape>> objects = {{Sphere<>{{9, 0, 0}, 1}, Picture{}},
                                                     {shape, paint}};
  try {
    check_objects(objects, {.eye = {0, 4, 6}, .target = {0, 0, 0}});
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return "";
}

/// A can under a picture that its normals would place.
struct CanLesson : LessonHooks {
  static constexpr About about{.idea = "a can", .numbers = Numbers::only_double};
  Stage stage{.light = {{5, 5, 5}}, .camera = {.eye = {0, 2, 8}, .target = {0, 0, 0}}};
  std::vector<Painted<Paint, AShape>> objects = {{Cylinder{}, Picture{}}};
  Color<double> operator()(const Ray<double>& ray) const { return stage.sky(ray); }
};

}  // namespace

TEST_CASE("a name that promises another kind of picture is refused") {
  const test::TemporaryFolder folder;
  for (const char* name : {"x.jpg", "x.jpeg", "x.gif", "x.bmp", "x.webp"})
    CHECK(status_of(folder / name) == 2);
  CHECK(folder.size() == 0);
  CHECK(status_of(folder / "jpg") == 0);
}

TEST_CASE("a picture that is placed by normals is refused on what is no sphere") {
  const std::string by_normals = "object 1: its picture is placed by its normals";
  CHECK(refusal_of(Cylinder{}, Picture{}).starts_with(by_normals));
  CHECK(refusal_of(Rectangle{}, Picture{}).starts_with(by_normals));
  CHECK(refusal_of(Cylinder{}, Label{}).empty());
  CHECK(refusal_of(Cylinder{}, Solid{}).empty());
  CHECK(refusal_of(HonestBowl{}, Picture{}).empty());
  const test::TemporaryFolder folder;
  CHECK(status_of<CanLesson>(folder / "can.png") == 1);
  CHECK(folder.size() == 0);
}

TEST_CASE("a shape that says that it is convex, and is open, is refused") {
  CHECK(refusal_of(Bowl{}, Solid{}).starts_with("object 1: convex() is true"));
  CHECK(refusal_of(HonestBowl{}, Solid{}).empty());
  CHECK(refusal_of(Rectangle{.up = {0, 1, 1}}, Solid{}).empty());
}
