// What run_chapter refuses of a lesson and of its user.
#include <doctest.h>

#include "02_checkerboard_uv/lesson.hpp"
#include "07_earth_by_sampling/lesson.hpp"
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

/// A wall before the camera, with a fault in its distance or in its hit.
struct Wall {
  double behind = 1, length = 1, lift = 1e-9, beside = 0;

  [[nodiscard]] static constexpr bool convex() { return false; }
};
double distance_to(const Wall& wall, const Ray<double>& ray) {
  const double t = -ray.origin.z / ray.direction.z;
  return t > 0 ? t * wall.behind : infinity<double>();
}
Hit<double> hit_at(const Wall& wall, const Ray<double>& ray, double distance) {
  const Point point = ray.origin + ray.direction * distance + Vec3d{wall.beside, 0, 0};
  return {{0, 0, wall.length}, point, point + Vec3d{0, 0, wall.lift}};
}

using Picture = Mapped<RtiowMapping, Checkerboard>;
using Label = Mapped<CylinderMapping, Checkerboard>;
using Paint = AnyOf<Solid, Picture, Label>;
using AShape = AnyShape<Sphere<>, Cylinder, Rectangle, Convex, Wall>;

struct SecondLesson : LessonHooks {
  static constexpr About about{.idea = "a second object", .numbers = Numbers::only_double};
  Stage stage{.light = {{5, 5, 5}}, .camera = {.eye = {0, 4, 6}, .target = {0, 0, 0}}};
  std::vector<Shiny<Paint, AShape>> objects = {{Sphere<>{{9, 0, 0}, 1}, Picture{}},
                                               {Cylinder{}, Picture{}}};
  Color<double> operator()(const Ray<double>& ray) const { return stage.sky(ray); }
};
void check_with(const AShape& shape, const Paint& paint) {
  SecondLesson lesson;
  lesson.objects[1] = {shape, paint};
  check_objects(lesson.objects, lesson.stage.camera);
}

}  // namespace

TEST_CASE("a name that promises another kind of picture is refused") {
  const test::TemporaryFolder folder;
  for (const char* name : {"x.jpg", "x.jpeg", "x.gif", "x.bmp", "x.webp", "x.JPG"})
    CHECK(status_of(folder / name) == 2);
  CHECK(folder.size() == 0);
  CHECK(status_of(folder / "jpg") == 0);
}

TEST_CASE("a picture that normals place is refused on a can; so is a can that says it is convex") {
  CHECK_THROWS_AS(check_with(Cylinder{}, Picture{}), std::logic_error);
  CHECK_NOTHROW(check_with(Cylinder{}, Label{}));
  CHECK_THROWS_AS(check_with(Convex{}, Label{}), std::logic_error);
  CHECK_NOTHROW(check_with(Rectangle{.up = {0, 1, 1}}, Label{}));
  const test::TemporaryFolder folder;
  CHECK(status_of<SecondLesson>(folder / "can.png") == 1);
}

TEST_CASE("a shape is refused whose hits are behind the eye, turned away, or not lifted") {
  CHECK_NOTHROW(check_with(Wall{}, Solid{}));
  const auto refused = [](const Wall& wall, const char* why) {
    CHECK_THROWS_WITH_AS(check_with(wall, Solid{}), doctest::Contains(why), std::logic_error);
  };
  refused({.behind = -1}, "not ahead of the ray");
  refused({.beside = 1}, "not at distance_to");
  refused({.length = 3}, "length is not 1");
  refused({.length = -1}, "does not face the ray");
  for (const double lift : {0.0, -1e-9, 5.0, std::nan("")}) refused({.lift = lift}, "`outside`");
}

TEST_CASE("a camera without a view is refused, and a sphere that no ray can meet") {
  const auto refused = [](const Camera& camera, double radius, const char* why) {
    Ready<chapter_02::Lesson> ready("stripes", {"--quiet", "--width", "8", "--height", "6"});
    ready.lesson.stage.camera = camera;
    ready.lesson.objects[2].shape.radius = radius;
    CHECK_THROWS_WITH_AS(ready.build(), doctest::Contains(why), std::logic_error);
  };
  refused({.eye = {1, 2, 3}, .target = {1, 2, 3}}, 1, "no upper side");
  refused({.eye = {0, 8, 0}, .target = {0, 0, 0}}, 1, "no upper side");
  for (const double angle : {0.0, 180.0, std::nan("")})
    refused({.eye = {0, 0, 8}, .target = {}, .fov_y_degrees = angle}, 1, "between 0 and 180");
  for (const double radius : {0.0, -1.0, std::nan("")})
    refused({.eye = {0, 0, 8}, .target = {}}, radius, "object 2: its radius is not above 0");
  struct Mixed {
    Stage stage;
    std::vector<Painted<Solid, AnyShape<Cylinder, Sphere<>>>> objects = {
        {.shape = Cylinder{}, .paint = {}}, {.shape = Sphere<>{{0, 0, 0}, -1}, .paint = {}}};
  } mixed;
  CHECK_THROWS_WITH_AS(check_scene(mixed), doctest::Contains("object 1: its radius"),
                       std::logic_error);
}

// Of objects with an index above 31 none is expected to change.
static_assert(ObjectSet{0, 31}.contains(31) && !ObjectSet{0, 31}.contains(32));

TEST_CASE("a lesson is refused whose options are not its own, or that forgets its samples") {
  struct Elsewhere : chapter_02::Lesson {
    Groups options() override {
      TextureFile texture{"earth.png"};
      return {texture};
    }
  };
  struct Forgets : chapter_07::Lesson {
    Groups options() override { return {texture}; }
  };
  const auto refused = [](auto lesson, const char* why) {
    CommandLine line("lesson", "");
    CHECK_THROWS_WITH_AS((void)offer_of(lesson, line), doctest::Contains(why), std::logic_error);
  };
  refused(Elsewhere{}, "groups that are members of the lesson");
  refused(Forgets{}, "names `sampling` in `options`");
}
