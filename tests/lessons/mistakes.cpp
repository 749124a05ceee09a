// Lessons with one mistake for each value of MISTAKE: they must not compile, and the message must
// name the mistake.
#include <vector>

#include "engine/run/run_chapter.hpp"
#include "engine/run/sampling_options.hpp"
#include "engine/run/texture_file.hpp"
#include "scene/paint.hpp"
#include "scene/stage.hpp"
#include "texture/filters.hpp"
#include "texture/mapped.hpp"

namespace texmap {

struct Base {
  Stage stage;
  std::vector<Painted<Solid>> objects;
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    return stage.sky(ray);
  }
};

/// A lesson without a mistake of its own, whose picture has a paint's colors.
template <class Paint>
struct Shows : LessonHooks, Base {
  static constexpr About about{.idea = "a paint"};
  Paint paint;
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    return paint(Hit<Real>{.normal = ray.direction});
  }
};

#if MISTAKE == 1
struct Lesson : LessonHooks, Base {
  static constexpr About about{.idea = "a sky"};
  void biuld(Chosen&) override {}
};
#elif MISTAKE == 2
struct Lesson : LessonHooks, Base {
  static constexpr About about{.idae = "a sky"};
};
#elif MISTAKE == 3
struct Lesson : Base {
  static constexpr About about{.idea = "a sky"};
};
#elif MISTAKE == 4
struct Lesson : LessonHooks, Base {};
#elif MISTAKE == 5
struct Lesson : LessonHooks, Base {
  static constexpr About about{.idea = "a sky"};
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) {
    return stage.sky(ray);
  }
};
#elif MISTAKE == 6
struct Lesson : LessonHooks, Base {
  static constexpr About about{.idea = "normals"};
  template <class Real>
  auto operator()(const Ray<Real>& ray) const {
    return color_along(objects, ray, stage.sky,
                       [](const auto&, const Hit<Real>& hit) { return hit.normal; });
  }
};
#elif MISTAKE == 7
struct Grays {
  template <class Real>
  Real operator()(const Uv<Real>& uv) const {
    return uv.u;
  }
};
using Lesson = Shows<Mapped<RtiowMapping, Grays>>;
#elif MISTAKE == 11
struct Lesson : LessonHooks, Base {
  static constexpr About about{.idea = "a picture that is never loaded"};
  TextureFile texture{"earth.png"};
  Groups options() override { return {texture}; }
  void biuld(Chosen&) {}
};
#elif MISTAKE == 12
struct Lesson : LessonHooks {
  static constexpr About about{.idea = "nothing is drawn"};
  Stage stage;
};
#elif MISTAKE == 13
struct Lesson : LessonHooks {
  static constexpr About about{.idea = "a sky"};
  Stage scene;
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    return scene.sky(ray);
  }
};
#elif MISTAKE == 14
struct Lesson : LessonHooks, Base {
  static constexpr About about{.idea = "a sheet"};
  void draw_all(Chosen&) override {}
};
#elif MISTAKE == 15
struct Lesson : LessonHooks, Base {
  static constexpr About about{.idea = "options that nobody keeps"};
  Groups options() override { return {TextureFile{"earth.png"}}; }
  void build(Chosen&) override {}
};
#elif MISTAKE == 16
struct Lesson : LessonHooks, Base {
  static constexpr About about{.idea = "options that nobody declares"};
  struct Sizes {
    double radius = 1;
  } sizes;
  Groups options() override { return {sizes}; }
  void build(Chosen&) override {}
};
#elif MISTAKE == 17
struct Striped {
  template <class Real>
  Color<Real> color(const Hit<Real>& hit) const {
    return gray(hit.point.x);
  }
};
using Lesson = Shows<AnyOf<Solid, Striped>>;
#elif MISTAKE == 18
struct Latitudes {
  template <class Real>
  Real operator()(const Vec3<Real>& normal) const {
    return normal.y;
  }
};
struct White {
  template <class Real>
  Color<Real> operator()(const Uv<Real>&) const {
    return gray(Real(1));
  }
};
using Lesson = Shows<Mapped<Latitudes, White>>;
#elif MISTAKE == 19
struct Lesson : PathLesson {
  static constexpr About about{.idea = "paths without objects"};
  Stage stage;
  template <class Real>
  Color<Real> operator()(const auto& scene, const PixelPlace<Real>&, auto&) const {
    return scene.sky.above;
  }
};
#elif MISTAKE == 20
struct Lesson : PathLesson, Base {
  static constexpr About about{.idea = "a ray where a path is wanted"};
};
#elif MISTAKE == 21
struct Disk : Sphere<> {};
template <class Real>
Real distanec_to(const Disk& disk, const Ray<Real>& ray) {
  return length(number_cast<Real>(disk.center) - ray.origin);
}
struct Lesson : LessonHooks, Base {
  static constexpr About about{.idea = "a shape without distance_to"};
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    return gray(find_nearest(std::vector<Painted<Solid, Disk>>{}, ray).distance);
  }
};
#elif MISTAKE == 22
using Lesson = Shows<Mapped<RtiowMapping, FilteredTexture>>;  // a filter has no case
#elif MISTAKE == 23
struct Lesson : LessonHooks {
  static constexpr About about{.idea = "a color that is not returned"};
  Stage stage;
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    static_cast<void>(stage.sky(ray));
  }
};
#elif MISTAKE == 24
class Lesson : LessonHooks, Base {
 public:
  static constexpr About about{.idea = "a class, so that its base is private"};
};
#elif MISTAKE == 25
struct Lesson : LessonHooks, Base {
  static constexpr About about{.size = {80, 60}};
};
#elif MISTAKE == 26
struct Lesson : LessonHooks, Base {
  About about{.idea = "of each lesson, not of all"};
};
#elif MISTAKE == 27
struct Lesson : PathLesson, Base {
  static constexpr About about{.idea = "a path to a direction"};
  template <class Real>
  auto operator()(const auto&, const PixelPlace<Real>& at, auto&) const {
    return Vec3<Real>{at.column, at.row, Real(0)};
  }
};
#elif MISTAKE == 28 || MISTAKE == 29
struct Disk {
  Point center{};
};
template <class Real>
Real distance_to(const Disk& disk, const Ray<Real>& ray) {
  return length(number_cast<Real>(disk.center) - ray.origin);
}
template <class Real>
Hit<Real> hit_at(const Disk&, const Ray<Real>& ray, const Real& distance) {
  return {.normal = ray.direction, .point = ray.direction * distance};
}
struct Lesson : LessonHooks, Base {
  static constexpr About about{.idea = "a shape without convex()"};
#if MISTAKE == 28
  std::vector<Painted<Solid, Disk>> objects;
#else
  std::vector<Painted<Solid, AnyShape<Sphere<>, Disk>>> objects;
#endif
};
#elif MISTAKE == 30
struct Upward {
  template <class Real>
  Uv<Real> operator()(const Vec3<Real>& normal) {  // not const
    return {normal.x, normal.z};
  }
};
using Lesson = Shows<Mapped<Upward, FilteredTexture>>;
#elif MISTAKE <= 10
struct Lesson : LessonHooks, Base {
#if MISTAKE == 8
  static constexpr About about{.idea = "a branch", .numbers = Numbers::no_intervals};
#else
  static constexpr About about{.idea = "a branch, or a wave"};
#endif
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
#if MISTAKE == 10
    return gray(sin(ray.direction.x));
#else
    if (ray.direction.y > Real(0)) return stage.sky(ray);
    return gray(Real(0));
#endif
  }
};
#endif

}  // namespace texmap

int main(int argc, char** argv) {
  return texmap::run_chapter<texmap::Lesson>("mistakes", argc, argv);
}
