// The exercises of chapter 10. The lesson's ProjectionMapping and ProjectionOptions are here
// structs that call the student's functions: to read the globe's picture, and to make it.
#include <cmath>
#include <numbers>

#include "10_projections/sheet.hpp"
#include "engine/app/projection_options.hpp"
#include "exercises.hpp"
#include "texture/projection_facts.hpp"

namespace texmap::check {

static Hook<Uv<double>(Vec3<double>)> on_cylinder;
static Hook<Uv<double>(Vec3<double>)> on_octahedron;
static Hook<Vec3<double>(Uv<double>)> direction_of;

}  // namespace texmap::check

namespace texmap::chapter_10 {

struct ProjectionMapping {
  Projection projection = Projection::equirect;

  Uv<double> operator()(const Vec3<double>& p) const {
    if (check::on_cylinder) return check::on_cylinder.yours(p);
    if (check::on_octahedron) return check::on_octahedron.yours(p);
    return project(projection, p);
  }
};

struct ProjectionOptions : texmap::ProjectionOptions {
  /// The file in the globe's layout; smaller, which is enough for the picture of an exercise.
  [[nodiscard]] ImageTexture load(const TextureFile& file) const {
    const ImageTexture earth{file.load()};
    ImageTexture made{Image(600, static_cast<int>(600 / facts_of(on_globe()).aspect))};
    for (int row = 0; row < made.image.height; ++row) {
      for (int column = 0; column < made.image.width; ++column) {
        const Uv<double> uv{(column + 0.5) / made.image.width, 1 - (row + 0.5) / made.image.height};
        const Vec3<double> p =
            check::direction_of ? check::direction_of.yours(uv) : unproject(on_globe(), uv);
        const Color<double> color = earth(uv_rtiow(p));
        made.image.at(column, row) = {byte_of(color.r), byte_of(color.g), byte_of(color.b)};
      }
    }
    return made;
  }
};

struct Lesson;
/// The program's sheet of all layouts is not drawn here.
inline void show_projections(const Lesson&, Session&) {}

}  // namespace texmap::chapter_10

#include "10_projections/lesson.hpp"

namespace texmap::check {
namespace {

using chapter_10::Lesson;
using Vector = Vec3<double>;
using Place2 = Uv<double>;

constexpr double pi = std::numbers::pi;

/// The globe from nearby, its picture in a layout.
Image globe(const char* layout) {
  auto lesson = prepared<Lesson>({"--projection", layout});
  lesson.stage.camera.fov_y_degrees = 18;
  return picture_of(lesson);
}

Exercise onto_a_cylinder() {
  const double r = std::sqrt(0.5);
  Law<Place2(Vector)> law{
      .right = uv_cylinder<double>,
      .places = {{"on +x, u is 1/2 and v is 1/2", {Vector{1, 0, 0}}},
                 {"on +z, u is 1/4", {Vector{0, 0, 1}}},
                 {"on -z, u is 3/4", {Vector{0, 0, -1}}},
                 {"halfway between +x and +z, u is 3/8", {Vector{r, 0, r}}},
                 {"at the height 0.6, (0.8, 0.6, 0), v is 0.8", {Vector{0.8, 0.6, 0}}},
                 {"at the height -0.6 v is 0.2", {Vector{0.8, -0.6, 0}}},
                 {"at the north pole v is 1", {Vector{0, 1, 0}}},
                 {"in the direction (-2, 1, 2) / 3", {Vector{-2. / 3, 1. / 3, 2. / 3}}}},
      .mistakes = {}};
  const auto wrong = [&](const char* word,
                         const std::function<Place2(Place2 right, Vector p)>& function) {
    law.mistakes.push_back({word, [=](Vector p) { return function(uv_cylinder(p), p); }});
  };
  wrong("v is the latitude here: that is the equirectangular layout. On the cylinder v is a height",
        [](Place2 uv, Vector p) {
          return Place2{uv.u, std::asin(p.y) / pi + 0.5};
        });
  wrong("u runs the other way: your map is mirrored", [](Place2 uv, Vector) {
    return Place2{1 - uv.u, uv.v};
  });
  wrong("v runs the other way: your map is upside down", [](Place2 uv, Vector) {
    return Place2{uv.u, 1 - uv.v};
  });
  wrong("y runs from -1 to 1 and v from 0 to 1: the lower half is missing", [](Place2 uv, Vector) {
    return Place2{uv.u, 2 * uv.v - 1};
  });
  wrong("you divide by 360, but std::atan2 returns radians: a whole turn is 2 pi",
        [](Place2 uv, Vector p) {
          return Place2{0.5 - std::atan2(p.z, p.x) / 360, uv.v};
        });
  wrong("u begins at -1/2: the half is missing", [](Place2 uv, Vector) {
    return Place2{uv.u - 0.5, uv.v};
  });
  wrong("std::atan2 takes z first, then x: your globe is turned and mirrored",
        [](Place2 uv, Vector p) {
          return Place2{0.5 - std::atan2(p.x, p.z) / (2 * pi), uv.v};
        });
  return exercise("10.1", "Uv on_cylinder(Vec3 p)", std::move(law), on_cylinder,
                  [] { return globe("cylinder"); });
}

/// (a, b) before the fold.
Place2 from_above(const Vector& p) {
  const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
  return {p.x / s, -p.z / s};
}
Place2 in_square(double a, double b) { return {(1 + a) / 2, (1 + b) / 2}; }

Exercise fold_an_octahedron() {
  Law<Place2(Vector)> law{
      .right = uv_octahedral<double>,
      .places = {{"the north pole +y is in the middle, (1/2, 1/2)", {Vector{0, 1, 0}}},
                 {"+x is in the middle of the right edge, (1, 1/2)", {Vector{1, 0, 0}}},
                 {"+z is in the middle of the lower edge, (1/2, 0)", {Vector{0, 0, 1}}},
                 {"halfway between +x and +y, at (1, 1, 0), u is 3/4", {Vector{1, 1, 0}}},
                 {"(1, 2, 1): |x| + |y| + |z| is 4, so u is 5/8 and v is 3/8", {Vector{1, 2, 1}}},
                 {"(-3, 4, -5), still on the upper half", {Vector{-3, 4, -5}}},
                 {"(4, -2, 2) is on the lower half: a = 1/2 and b = -1/4 become 3/4 and -1/2",
                  {Vector{4, -2, 2}}},
                 {"(-4, -2, 2) is mirrored to the left: a becomes -3/4", {Vector{-4, -2, 2}}},
                 {"(1, -2, -5), on the lower half behind", {Vector{1, -2, -5}}},
                 {"(-1, -8, 3), close to the south pole: close to a corner", {Vector{-1, -8, 3}}}},
      .mistakes = {}};
  /// `fold` is called with (a, b) of a point of the lower half.
  const auto wrong = [&](const char* word, const std::function<Place2(double a, double b)>& fold) {
    law.mistakes.push_back({word, [=](Vector p) {
                              const Place2 at = from_above(p);
                              const Place2 moved = p.y < 0 ? fold(at.u, at.v) : at;
                              return in_square(moved.u, moved.v);
                            }});
  };
  wrong("nothing is folded: the southern half lies on the northern one", [](double a, double b) {
    return Place2{a, b};
  });
  wrong("the signs are missing: all lower faces land in the corner at the upper right",
        [](double a, double b) {
          return Place2{1 - std::abs(b), 1 - std::abs(a)};
        });
  wrong("a needs 1 - |b|, and b needs 1 - |a|: the mirror exchanges them", [](double a, double b) {
    return Place2{std::copysign(1 - std::abs(a), a), std::copysign(1 - std::abs(b), b)};
  });
  wrong("you compute b from the new a: keep the old one in a variable", [](double a, double b) {
    const double folded = std::copysign(1 - std::abs(b), a);
    return Place2{folded, std::copysign(1 - std::abs(folded), b)};
  });
  const auto other = [&](const char* word, std::function<Place2(Vector)> function) {
    law.mistakes.push_back({word, std::move(function)});
  };
  other("b is -z / s: yours is z / s, and north and south edges are exchanged", [](Vector p) {
    return uv_octahedral(Vector{p.x, p.y, -p.z});
  });
  other("you fold where y is above 0: only the lower half is folded out", [](Vector p) {
    const auto [a, b] = from_above(p);
    if (p.y <= 0) return in_square(a, b);
    return in_square(std::copysign(1 - std::abs(b), a), std::copysign(1 - std::abs(a), b));
  });
  other("divide by |x| + |y| + |z|, not by the length: the point must lie on the octahedron",
        [](Vector p) {
          const Vector n = normalize(p);
          if (p.y >= 0) return in_square(n.x, -n.z);
          return in_square(std::copysign(1 - std::abs(n.z), n.x),
                           std::copysign(1 - std::abs(n.x), -n.z));
        });
  return exercise("10.2", "Uv on_octahedron(Vec3 p)", std::move(law), on_octahedron,
                  [] { return globe("octahedral"); });
}

Exercise back_from_the_cylinder() {
  Law<Vector(Place2)> law{
      .right = [](Place2 uv) { return unproject(Projection::cylinder, uv); },
      .places = {{"at (1/2, 1/2) is +x", {Place2{0.5, 0.5}}},
                 {"at (1/4, 1/2) is +z", {Place2{0.25, 0.5}}},
                 {"at (3/4, 1/2) is -z", {Place2{0.75, 0.5}}},
                 {"at (3/8, 1/2) is the point halfway between +x and +z", {Place2{0.375, 0.5}}},
                 {"the upper edge, v = 1, is the north pole everywhere", {Place2{0.25, 1}}},
                 {"at (1/2, 0.8) the height is 0.6 and x is 0.8", {Place2{0.5, 0.8}}},
                 {"at (1/2, 0.2) the height is -0.6", {Place2{0.5, 0.2}}},
                 {"at (0.1, 0.9)", {Place2{0.1, 0.9}}}},
      .mistakes = {}};
  const auto wrong = [&](const char* word, std::function<Vector(Place2)> function) {
    law.mistakes.push_back({word, std::move(function)});
  };
  const auto right = law.right;
  const auto at = [](double angle, double radius, double y) {
    return Vector{radius * std::cos(angle), y, radius * std::sin(angle)};
  };
  const auto turn = [](Place2 uv) { return (0.5 - uv.u) * 2 * pi; };
  const auto height = [](Place2 uv) { return 2 * uv.v - 1; };
  const auto radius = [=](Place2 uv) { return std::sqrt(1 - height(uv) * height(uv)); };
  wrong(
      "the circle gets smaller toward the poles: your points are on the cylinder, not on the "
      "sphere",
      [=](Place2 uv) { return at(turn(uv), 1, height(uv)); });
  wrong("the radius is sqrt(1 - y^2), by Pythagoras; with 1 - |y| the points are on two cones",
        [=](Place2 uv) { return at(turn(uv), 1 - std::abs(height(uv)), height(uv)); });
  wrong("std::cos and std::sin take radians: your angle is in degrees",
        [=](Place2 uv) { return at(360 * (0.5 - uv.u), radius(uv), height(uv)); });
  wrong("u runs the other way: your map is mirrored",
        [=](Place2 uv) { return at(-turn(uv), radius(uv), height(uv)); });
  wrong("v runs the other way: your map is upside down",
        [=](Place2 uv) { return at(turn(uv), radius(uv), -height(uv)); });
  wrong("v is no latitude here, it is a height: yours goes back from the equirectangular layout",
        [](Place2 uv) { return direction_rtiow(uv); });
  wrong("x belongs to the cosine and z to the sine: yours are exchanged", [=](Place2 uv) {
    const Vector p = right(uv);
    return Vector{p.z, p.y, p.x};
  });
  wrong("v runs from 0 to 1, y from -1 to 1: the southern half is missing",
        [=](Place2 uv) { return at(turn(uv), std::sqrt(1 - uv.v * uv.v), uv.v); });
  return exercise("10.3", "Vec3 direction_of(Uv uv)", std::move(law), direction_of,
                  [] { return globe("cylinder"); });
}

/// Texels of an equirectangular picture with no texel larger than those of an equal-area one.
double texels_needed() {
  const Vector on_equator{0.8, 0, 0.6};
  return std::ceil(1024 * 1024 * distortion(Projection::equirect, on_equator).area);
}

/// The latitude at which the lesson's globe shows what its file has at 45 degrees.
double latitude_by_cylinder() {
  const double v = uv_rtiow(Vector{1, 1, 0}).v;
  return std::asin(unproject(Projection::cylinder, Place2{0.5, v}).y) * 180 / pi;
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      .exercises = {onto_a_cylinder(), fold_an_octahedron(), back_from_the_cylinder()},
      .questions =
          {{"10.a",
            "An equal-area octahedral picture has 1024 x 1024 texels. How many texels must an "
            "equirectangular picture have, if its largest texel may cover no more of the globe "
            "than one texel of the first picture?",
            texels_needed, "texels", 2e-3},
           {"10.b",
            "You read an equirectangular file as if it were a cylinder's. At which latitude of the "
            "globe do you see what the file has at 45 degrees north?",
            latitude_by_cylinder, "degrees", 1e-3}},
  };
  return chapter;
}

}  // namespace texmap::check
