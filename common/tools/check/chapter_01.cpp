// The exercises of chapter 01. The lesson is the chapter's own. Its color_along and sample_light
// are these here, which call the student's function.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises.hpp"
#include "scene/light.hpp"

namespace texmap::check {

using Vector = Vec3<double>;
using FirstHit = std::function<double(Vector, Vector)>;

static Hook<double(Vector, Vector, Vector, double)> distance_to_sphere;
static Hook<double(Vector, Vector, Vector)> cosine_of;
static Hook<bool(Vector, Vector, Vector, const FirstHit&)> in_shadow;

/// The distance to the first of `objects`, each with a `shape`, along a ray; infinity for a miss.
template <class Objects>
[[nodiscard]] static FirstHit first_hit_on(const Objects& objects) {
  return [&objects](const Vector& origin, const Vector& direction) {
    return find_nearest(objects, Ray<double>{origin, direction}).distance;
  };
}

}  // namespace texmap::check

namespace texmap::chapter_01 {

inline constexpr struct {
  template <class Objects, class Background, class Shade>
  Color<double> operator()(const Objects& objects, const Ray<double>& ray,
                           const Background& background, const Shade& shade) const {
    if (!check::distance_to_sphere) return texmap::color_along(objects, ray, background, shade);
    auto first = infinity<double>();
    auto found = objects.end();
    for (auto object = objects.begin(); object != objects.end(); ++object) {
      const double distance = check::distance_to_sphere.yours(
          ray.origin, ray.direction, object->shape.center, object->shape.radius);
      if (distance < first) {
        first = distance;
        found = object;
      }
    }
    if (found == objects.end()) return background(ray);
    return shade(*found, hit_at(found->shape, ray, first));
  }
} color_along;

inline constexpr struct {
  template <class Objects>
  LightSample<double> operator()(const PointLight& light, const Objects& objects,
                                 const Hit<double>& hit) const {
    const Vec3<double> path = light.position - hit.point;
    const Vec3<double> to_light = normalize(path);
    const double cosine = check::cosine_of
                              ? check::cosine_of.yours(hit.point, hit.normal, light.position)
                              : std::max(dot(hit.normal, to_light), 0.0);
    if (cosine <= 0) return {to_light, cosine};
    const bool hidden =
        check::in_shadow
            ? check::in_shadow.yours(hit.point, hit.normal, light.position,
                                     check::first_hit_on(objects))
            : is_occluded(objects, Ray<double>{hit.outside, to_light}, length(path), hit.shape);
    return {to_light, hidden ? 0 : cosine};
  }
} sample_light;

}  // namespace texmap::chapter_01

#include "01_plain_spheres/lesson.hpp"

namespace texmap::check {
namespace {

Exercise where_the_ray_meets_the_sphere() {
  const auto never = infinity<double>();
  const auto root = [](const Vector& f, const Vector& d, double r, double sign) {
    const double b = dot(f, d);
    return (-b + sign * std::sqrt(b * b - dot(d, d) * (dot(f, f) - r * r))) / dot(d, d);
  };
  const auto ahead = [=](double t) { return t > 0 ? t : never; };
  const auto first = [=](const Vector& f, const Vector& d, double r) {
    const double entry = root(f, d, r, -1);
    return entry > 0 ? entry : ahead(root(f, d, r, 1));
  };
  const Vector middle{0, 0, 0};
  const Vector eye{0, 0, 5};
  Law<double(Vector, Vector, Vector, double)> law{
      .right =
          [](const Vector& o, const Vector& d, const Vector& center, double r) {
            return distance_to(Sphere<>{center, r}, Ray<double>{o, d});
          },
      .places = {{"from (0, 0, 5) straight at the unit sphere, t is 4",
                  {eye, Vector{0, 0, -1}, middle, 1}},
                 {"from (0, 0.6, 5) in the direction (0, 0, -1), t is 4.2",
                  {Vector{0, 0.6, 5}, Vector{0, 0, -1}, middle, 1}},
                 {"a sphere of radius 1/2 around (3, 1, -2): from (3, 1, 4), t is 5.5",
                  {Vector{3, 1, 4}, Vector{0, 0, -1}, Vector{3, 1, -2}, 0.5}},
                 {"distances are in lengths of the direction: with (0, 0, -2), t is 2",
                  {eye, Vector{0, 0, -2}, middle, 1}},
                 {"a ray that passes the sphere never meets it",
                  {eye, Vector{0, 1, -1}, middle, 1}},
                 {"a sphere behind the origin is never met", {eye, Vector{0, 0, 1}, middle, 1}},
                 {"from inside, the ray meets the sphere where it leaves it",
                  {Vector{0, 0, 0.5}, Vector{0, 0, 1}, middle, 1}}},
      .mistakes = {},
      .tolerance = 1e-9};
  const auto wrong = [&](const char* word, auto function) {
    law.mistakes.push_back({word, [=](const Vector& o, const Vector& d, const Vector& center,
                                      double r) { return function(o - center, d, r); }});
  };
  wrong("this is where the ray leaves the sphere: the smaller t comes first",
        [=](const Vector& f, const Vector& d, double r) { return ahead(root(f, d, r, 1)); });
  wrong("this is where the ray leaves the sphere, and it may be behind the origin",
        [=](const Vector& f, const Vector& d, double r) {
          const double t = root(f, d, r, 1);
          return std::isnan(t) ? never : t;
        });
  wrong("a t below 0 is behind the origin: only t > 0 counts",
        [=](const Vector& f, const Vector& d, double r) {
          const double t = root(f, d, r, -1);
          return std::isnan(t) ? never : t;
        });
  wrong("the smaller t is behind the origin if the ray starts inside: then take the larger one",
        [=](const Vector& f, const Vector& d, double r) { return ahead(root(f, d, r, -1)); });
  wrong("the square root of a negative number is NaN: if the discriminant is below 0, return first",
        [=](const Vector& f, const Vector& d, double r) {
          const double t = root(f, d, r, -1);
          return t > 0 || std::isnan(t) ? t : ahead(root(f, d, r, 1));
        });
  wrong("the ray runs backward: f is origin - center, and b is -dot(f, direction)",
        [=](const Vector& f, const Vector& d, double r) { return first(f, d * -1.0, r); });
  wrong("the direction may have any length: divide by a = dot(direction, direction)",
        [=](const Vector& f, const Vector& d, double r) { return first(f, d, r) * dot(d, d); });
  wrong("this is right for directions of length 1 alone: a is dot(direction, direction)",
        [=](const Vector& f, const Vector& d, double r) { return first(f, normalize(d), r); });
  return exercise(
      "01.1", "double distance_to_sphere(Vec3 origin, Vec3 direction, Vec3 center, double radius)",
      std::move(law), distance_to_sphere, [] { return drawn<chapter_01::Lesson>(); });
}

Exercise how_straight_the_light_falls() {
  const Vector up{0, 1, 0};
  const Vector origin{0, 0, 0};
  Law<double(Vector, Vector, Vector)> law{
      .right =
          [](const Vector& point, const Vector& normal, const Vector& lamp) {
            return std::max(dot(normal, normalize(lamp - point)), 0.0);
          },
      .places = {{"a lamp straight above, at distance 1: the cosine is 1",
                  {origin, up, Vector{0, 1, 0}}},
                 {"a lamp straight above, at distance 3: the cosine is 1, too",
                  {origin, up, Vector{0, 3, 0}}},
                 {"a lamp at 60 degrees from the normal: the cosine is 1/2",
                  {origin, up, Vector{std::sqrt(3.0), 1, 0}}},
                 {"point (5, 0, 2), lamp at 60 degrees from the normal there: the cosine is 1/2",
                  {Vector{5, 0, 2}, up, Vector{5 + std::sqrt(3.0), 1, 2}}},
                 {"normal (1, 0, 0), point (0, 0, 0), lamp (3, 0, 4): the cosine is 0.6",
                  {origin, Vector{1, 0, 0}, Vector{3, 0, 4}}},
                 {"a lamp behind the surface: return 0", {origin, up, Vector{1, -2, 0}}},
                 {"a lamp in the plane of the surface: the cosine is 0",
                  {origin, up, Vector{0, 0, 2}}}},
      .mistakes = {},
      .tolerance = 1e-9};
  struct Angle {
    double cosine, length, from_the_origin;
  };
  const auto wrong = [&](const char* word, double (*function)(const Angle&)) {
    law.mistakes.push_back(
        {word, [function](const Vector& point, const Vector& normal, const Vector& lamp) {
           const Vector path = lamp - point;
           return function(
               {dot(normal, normalize(path)), length(path), dot(normal, normalize(lamp))});
         }});
  };
  wrong("the direction to the lamp does not have length 1: normalize it",
        [](const Angle& l) { return std::max(l.cosine * l.length, 0.0); });
  wrong("the signs are wrong: the direction or the normal points inward, so the dark side is lit",
        [](const Angle& l) { return std::max(-l.cosine, 0.0); });
  wrong("a lamp behind the surface gives negative light: nothing is cut off at 0",
        [](const Angle& l) { return l.cosine; });
  wrong("the direction to the lamp does not have length 1, and nothing is cut off at 0",
        [](const Angle& l) { return l.cosine * l.length; });
  wrong("the signs are wrong, and nothing is cut off at 0",
        [](const Angle& l) { return -l.cosine; });
  wrong("the side away from the lamp is lit, too: use std::max(c, 0.0), not the absolute value",
        [](const Angle& l) { return std::abs(l.cosine); });
  wrong("lamp is a position: subtract the point to get the direction from there to the lamp",
        [](const Angle& l) { return std::max(l.from_the_origin, 0.0); });
  wrong("this is the angle; the dot product already is its cosine",
        [](const Angle& l) { return std::acos(l.cosine); });
  return exercise("01.2", "double cosine_of(Vec3 point, Vec3 normal, Vec3 lamp)", std::move(law),
                  cosine_of, [] { return drawn<chapter_01::Lesson>(); });
}

/// The chapter's scene with the lamp between the left and the middle sphere: now spheres are
/// behind the lamp, too.
Image with_a_low_lamp() {
  auto lesson = prepared<chapter_01::Lesson>();
  lesson.stage.light.position = {-1.3, 0.8, 1.2};
  return picture_of(lesson);
}

Exercise is_the_lamp_hidden() {
  struct Ball {
    Sphere<> shape;
  };
  static const std::vector<Ball> balls = {{{{0, 0, 0}, 1}}, {{{0, 4, 0}, 0.5}}, {{{0, 20, 0}, 1}}};
  const FirstHit scene = first_hit_on(balls);
  const Vector up{0, 1, 0};
  const Vector top{0, 1, 0};
  using Function = bool(Vector, Vector, Vector, const FirstHit&);
  const auto towards = [](Vector start, Vector lamp, const FirstHit& first_hit) {
    return first_hit(start, normalize(lamp - start)) < length(lamp - start);
  };
  Law<Function> law{
      .right = [=](const Vector& point, const Vector& normal, const Vector& lamp,
                   const FirstHit& hit) { return towards(point + normal * 0.001, lamp, hit); },
      .places =
          {{"a sphere is between the point and the lamp: the lamp is hidden",
            {top, up, Vector{0, 8, 0}, scene}},
           {"nothing is between the point and the lamp: the lamp is not hidden",
            {top, up, Vector{5, 5, 0}, scene}},
           {"rounding put the point 1e-12 below its own sphere: this sphere does not hide the lamp",
            {Vector{0, 1 - 1e-12, 0}, up, Vector{5, 5, 0}, scene}},
           {"a point under a sphere, and nothing between it and the lamp below: it is not hidden",
            {Vector{0, -1, 0}, Vector{0, -1, 0}, Vector{5, -5, 0}, scene}},
           {"a sphere behind the lamp does not hide the lamp", {top, up, Vector{0, 3, 0}, scene}},
           {"a sphere 5 times as far away as the lamp does not hide the lamp",
            {Vector{0, 4.5, 0}, up, Vector{0, 7.3, 0}, scene}},
           {"a sphere on the other side of the point does not hide the lamp",
            {Vector{0, 7, 0}, up, Vector{0, 10, 0}, scene}}},
      .mistakes = {}};
  const auto wrong = [&](const char* word, std::function<Function> function) {
    law.mistakes.push_back({word, std::move(function)});
  };
  wrong("the ray starts on the sphere, and rounding lets it meet that sphere: start 0.001 above",
        [=](const Vector& p, const Vector&, const Vector& lamp, const FirstHit& hit) {
          return towards(p, lamp, hit);
        });
  wrong("the ray starts below the surface: add normal * 0.001, do not subtract it",
        [=](const Vector& p, const Vector& n, const Vector& lamp, const FirstHit& hit) {
          return towards(p - n * 0.001, lamp, hit);
        });
  for (const double lift : {0.001, 0.0}) {
    wrong("a sphere behind the lamp casts no shadow: compare with the distance of the lamp",
          [=](const Vector& p, const Vector& n, const Vector& lamp, const FirstHit& hit) {
            return hit(p + n * lift, lamp - p) < infinity<double>();
          });
    wrong("distances are in lengths of the direction: normalize it, or compare with 1",
          [=](const Vector& p, const Vector& n, const Vector& lamp, const FirstHit& hit) {
            return hit(p + n * lift, lamp - p) < length(lamp - p);
          });
    wrong("the ray runs away from the lamp: its direction is lamp - point",
          [=](const Vector& p, const Vector& n, const Vector& lamp, const FirstHit& hit) {
            return hit(p + n * lift, normalize(p - lamp)) < length(lamp - p);
          });
  }
  wrong("true and false are exchanged: the lamp is hidden if something is nearer than it",
        [=](const Vector& p, const Vector& n, const Vector& lamp, const FirstHit& hit) {
          return !towards(p + n * 0.001, lamp, hit);
        });
  return exercise("01.3",
                  "bool in_shadow(Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit)",
                  std::move(law), in_shadow, with_a_low_lamp);
}

/// The angle, in degrees, at which a surface of the lesson is half as bright as where light falls
/// straight on it.
double half_bright_angle() {
  const Lambertian surface = chapter_01::Lesson{}.surface;
  const double half = (surface.ambient + surface.diffuse) / 2;
  return std::acos((half - surface.ambient) / surface.diffuse) * 180 / std::numbers::pi;
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      .exercises = {where_the_ray_meets_the_sphere(), how_straight_the_light_falls(),
                    is_the_lamp_hidden()},
      .questions = {{"01.a",
                     "The right sphere has the color (0.2, 0.2, 0.8), and one of its points is in "
                     "shadow. Which number, 0 to 255, does the pixel there have for blue? "
                     "Decimals are cut off.",
                     [] {
                       const chapter_01::Lesson lesson;
                       const Rgb paint = lesson.objects[chapter_01::right].paint.color;
                       return static_cast<double>(byte_of(paint.b * lesson.surface.ambient));
                     },
                     "", 0},
                    {"01.b",
                     "At which angle of the light, in degrees from the normal, is a surface half "
                     "as bright as where the light falls straight on it?",
                     half_bright_angle, "degrees", 0.005}},
  };
  return chapter;
}

}  // namespace texmap::check
