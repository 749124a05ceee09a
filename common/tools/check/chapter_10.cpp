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

/// Places on the cylinder as many compute them.
std::vector<Mistake<Place2(Vector)>> wrong_cylinders() {
  std::vector<Mistake<Place2(Vector)>> mistakes;
  const auto wrong_u = [&](const char* word, double (*u)(const Vector&)) {
    mistakes.push_back({word, [=](Vector p) { return Place2{u(p), (1 + p.y) / 2}; }});
    mistakes.push_back({word, [=](Vector p) { return Place2{u(p), p.y}; }});
  };
  const auto wrong_v = [&](const char* word, double (*v)(double y)) {
    mistakes.push_back({word, [=](Vector p) { return Place2{uv_cylinder(p).u, v(p.y)}; }});
  };
  const char* latitude =
      "v is the latitude here: that is the equirectangular layout. On the cylinder v is a height";
  wrong_v(latitude, [](double y) { return std::asin(y) / pi + 0.5; });
  wrong_v(latitude, [](double y) { return std::acos(y) / pi; });
  wrong_v("v runs the other way: your map is upside down", [](double y) { return (1 - y) / 2; });
  const char* half = "y runs from -1 to 1 and v from 0 to 1: the lower half is missing";
  wrong_v(half, [](double y) { return y; });
  wrong_v(half, [](double y) { return std::abs(y); });
  wrong_v(half, [](double y) { return std::max(y, 0.); });
  wrong_v("v runs from 0 to 2: halve 1 + y", [](double y) { return 1 + y; });
  wrong_v("/ comes before +: write (1 + y) / 2", [](double y) { return 1 + y / 2; });
  wrong_v("v runs from -1/2 to 1/2: the half is missing (1 / 2 with int is 0)",
          [](double y) { return y / 2; });
  wrong_v("v runs from -1/2 to 3/2: y from -1 to 1 is twice as long as v, so halve it",
          [](double y) { return 0.5 + y; });
  wrong_v("this goes back, from v to y: v is (1 + y) / 2", [](double y) { return 2 * y - 1; });
  wrong_u("u runs the other way: your map is mirrored",
          [](const Vector& p) { return 0.5 + std::atan2(p.z, p.x) / (2 * pi); });
  wrong_u("std::atan2 returns radians: divide by 2 pi, not by 360",
          [](const Vector& p) { return 0.5 - std::atan2(p.z, p.x) / 360; });
  wrong_u("u begins at -1/2: the half is missing (1 / 2 with int is 0)",
          [](const Vector& p) { return -std::atan2(p.z, p.x) / (2 * pi); });
  wrong_u("u runs the other way, and begins at -1/2: it is 1/2 minus the share of a turn",
          [](const Vector& p) { return std::atan2(p.z, p.x) / (2 * pi); });
  wrong_u("a whole turn is 2 pi, not pi: u runs twice too far",
          [](const Vector& p) { return 0.5 - std::atan2(p.z, p.x) / pi; });
  wrong_u("/ 2 * pi divides by 2 and multiplies by pi: write / (2 * pi)",
          [](const Vector& p) { return 0.5 - std::atan2(p.z, p.x) / 2 * pi; });
  wrong_u("the angle is no share of a turn: divide it by 2 pi",
          [](const Vector& p) { return 0.5 - std::atan2(p.z, p.x); });
  wrong_u("/ comes before -: divide the angle alone, and subtract it from 1/2",
          [](const Vector& p) { return (0.5 - std::atan2(p.z, p.x)) / (2 * pi); });
  wrong_u("u is off by 1/2: on +x it is 1/2, and the seam is on -x",
          [](const Vector& p) { return 1 - std::atan2(p.z, p.x) / (2 * pi); });
  wrong_u("std::atan2 takes z first, then x: your globe is turned and mirrored",
          [](const Vector& p) { return 0.5 - std::atan2(p.x, p.z) / (2 * pi); });
  wrong_u("std::atan2 takes z first, then x: your globe is turned and mirrored",
          [](const Vector& p) { return 0.5 + std::atan2(p.x, p.z) / (2 * pi); });
  wrong_u("std::atan cannot tell the front from the back: take std::atan2(p.z, p.x)",
          [](const Vector& p) { return 0.5 - std::atan(p.z / p.x) / (2 * pi); });
  wrong_u("y is the axis: the angle around it is std::atan2(p.z, p.x)",
          [](const Vector& p) { return 0.5 - std::atan2(p.y, p.x) / (2 * pi); });
  mistakes.push_back({"u and v are exchanged: u goes around, v up", [](Vector p) {
                        const Place2 uv = uv_cylinder(p);
                        return Place2{uv.v, uv.u};
                      }});
  return mistakes;
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
      .mistakes = wrong_cylinders()};
  return exercise("10.1", "Uv on_cylinder(Vec3 p)", std::move(law), on_cylinder,
                  [] { return globe("cylinder"); });
}

/// (a, b) before the fold.
Place2 from_above(const Vector& p) {
  const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
  return {p.x / s, -p.z / s};
}
Place2 in_square(double a, double b) { return {(1 + a) / 2, (1 + b) / 2}; }

/// Folds of the lower half as many write them, called with (a, b).
void add_wrong_folds(std::vector<Mistake<Place2(Vector)>>& mistakes) {
  const auto wrong = [&](const char* word, Place2 (*fold)(double a, double b)) {
    mistakes.push_back({word, [=](Vector p) {
                          const Place2 at = from_above(p);
                          const Place2 moved = p.y < 0 ? fold(at.u, at.v) : at;
                          return in_square(moved.u, moved.v);
                        }});
  };
  static constexpr auto rest = [](double x) { return 1 - std::abs(x); };
  wrong("nothing is folded: the southern half lies on the northern one", [](double a, double b) {
    return Place2{a, b};
  });
  wrong("the signs are missing: all lower faces land in the corner at the upper right",
        [](double a, double b) {
          return Place2{rest(b), rest(a)};
        });
  wrong("the signs are exchanged: a keeps the sign of a, b that of b", [](double a, double b) {
    return Place2{std::copysign(rest(b), b), std::copysign(rest(a), a)};
  });
  wrong("the signs are turned around: a keeps its sign, and b keeps its sign",
        [](double a, double b) {
          return Place2{-std::copysign(rest(b), a), -std::copysign(rest(a), b)};
        });
  wrong("a needs 1 - |b|, and b needs 1 - |a|: the mirror exchanges them", [](double a, double b) {
    return Place2{std::copysign(rest(a), a), std::copysign(rest(b), b)};
  });
  wrong("b is not folded: its new value needs the old a, so keep that in a variable",
        [](double a, double b) {
          const double folded = std::copysign(rest(b), a);
          return Place2{folded, std::copysign(rest(folded), b)};
        });
  wrong("the bars are missing: it is 1 - |b| and 1 - |a|, without signs", [](double a, double b) {
    return Place2{(1 - b) * (a < 0 ? -1 : 1), (1 - a) * (b < 0 ? -1 : 1)};
  });
  wrong("the bars and the signs are missing: it is sign(a) (1 - |b|) and sign(b) (1 - |a|)",
        [](double a, double b) {
          return Place2{1 - b, 1 - a};
        });
  wrong("the size of a counts twice: multiply by its sign, 1 or -1", [](double a, double b) {
    return Place2{a * rest(b), b * rest(a)};
  });
  wrong("1 + |b| leaves the square: it is 1 - |b| and 1 - |a|", [](double a, double b) {
    return Place2{std::copysign(1 + std::abs(b), a), std::copysign(1 + std::abs(a), b)};
  });
  wrong("a is not folded: its new value needs the old b, so keep that in a variable",
        [](double a, double b) {
          return Place2{a, std::copysign(rest(a), b)};
        });
}

/// Places on the unfolded octahedron as many compute them.
std::vector<Mistake<Place2(Vector)>> wrong_octahedra() {
  std::vector<Mistake<Place2(Vector)>> mistakes;
  add_wrong_folds(mistakes);
  const auto wrong = [&](const char* word, Place2 (*function)(const Vector&)) {
    mistakes.push_back({word, function});
  };
  /// From (a, b), folded where y < 0.
  static constexpr auto folded = [](double a, double b, double y) {
    if (y >= 0) return in_square(a, b);
    return in_square(std::copysign(1 - std::abs(b), a), std::copysign(1 - std::abs(a), b));
  };
  wrong("b is -z / s: yours is z / s, and north and south edges are exchanged",
        [](const Vector& p) {
          return uv_octahedral(Vector{p.x, p.y, -p.z});
        });
  wrong("a is x / s: yours is -x / s, so west and east are exchanged", [](const Vector& p) {
    return uv_octahedral(Vector{-p.x, p.y, p.z});
  });
  wrong("you fold where y is above 0: only the lower half is folded out", [](const Vector& p) {
    const auto [a, b] = from_above(p);
    return folded(a, b, p.y > 0 ? -1 : 1);
  });
  wrong("you fold everywhere: only the lower half, y < 0, is folded out", [](const Vector& p) {
    const auto [a, b] = from_above(p);
    return folded(a, b, -1);
  });
  wrong("you fold where z is below 0: the lower half is where y < 0", [](const Vector& p) {
    const auto [a, b] = from_above(p);
    return folded(a, b, p.z);
  });
  wrong("divide by |x| + |y| + |z|, not by the length: the point must lie on the octahedron",
        [](const Vector& p) {
          const Vector n = normalize(p);
          return folded(n.x, -n.z, p.y);
        });
  wrong("p may have any length: divide it by |x| + |y| + |z|",
        [](const Vector& p) { return folded(p.x, -p.z, p.y); });
  wrong("the bars are missing in the sum: divide by |x| + |y| + |z|", [](const Vector& p) {
    const double s = p.x + p.y + p.z;
    return folded(p.x / s, -p.z / s, p.y);
  });
  wrong("y is missing in the sum: divide by |x| + |y| + |z|", [](const Vector& p) {
    const double s = std::abs(p.x) + std::abs(p.z);
    return folded(p.x / s, -p.z / s, p.y);
  });
  wrong("divide by the sum |x| + |y| + |z|, not by the largest of them: that is a cube",
        [](const Vector& p) {
          const double s = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
          return folded(p.x / s, -p.z / s, p.y);
        });
  wrong("seen from above the place is (x, -z): you take y, as seen from the front",
        [](const Vector& p) {
          const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
          return folded(p.x / s, p.y / s, p.y);
        });
  const char* moved =
      "a and b run from -1 to 1, u and v from 0 to 1: return (1 + a) / 2 and (1 + b) / 2";
  wrong(moved, [](const Vector& p) {
    const Place2 uv = uv_octahedral(p);
    return Place2{2 * uv.u - 1, 2 * uv.v - 1};
  });
  wrong(moved, [](const Vector& p) {
    const Place2 uv = uv_octahedral(p);
    return Place2{uv.u - 0.5, uv.v - 0.5};
  });
  wrong(moved, [](const Vector& p) {
    const Place2 uv = uv_octahedral(p);
    return Place2{2 * uv.u, 2 * uv.v};
  });
  wrong("/ comes before +: write (1 + a) / 2 and (1 + b) / 2", [](const Vector& p) {
    const Place2 uv = uv_octahedral(p);
    return Place2{uv.u + 0.5, uv.v + 0.5};
  });
  wrong("u and v are exchanged: u comes from a, v from b", [](const Vector& p) {
    const Place2 uv = uv_octahedral(p);
    return Place2{uv.v, uv.u};
  });
  return mistakes;
}

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
      .mistakes = wrong_octahedra()};
  return exercise("10.2", "Uv on_octahedron(Vec3 p)", std::move(law), on_octahedron,
                  [] { return globe("octahedral"); });
}

/// Directions of a place as many compute them.
std::vector<Mistake<Vector(Place2)>> wrong_directions() {
  std::vector<Mistake<Vector(Place2)>> mistakes;
  const auto wrong = [&](const char* word, std::function<Vector(Place2)> function) {
    mistakes.push_back({word, std::move(function)});
  };
  const auto at = [](double angle, double radius, double y) {
    return Vector{radius * std::cos(angle), y, radius * std::sin(angle)};
  };
  const auto turn = [](Place2 uv) { return (0.5 - uv.u) * 2 * pi; };
  const auto radius = [](double y) { return std::sqrt(1 - y * y); };
  const auto wrong_angle = [&](const char* word, double (*angle)(double u)) {
    wrong(word, [=](Place2 uv) { return at(angle(uv.u), radius(2 * uv.v - 1), 2 * uv.v - 1); });
  };
  const auto wrong_radius = [&](const char* word, double (*radius_of)(double y)) {
    wrong(word, [=](Place2 uv) {
      const double y = 2 * uv.v - 1;
      return at(turn(uv), radius_of(y), y);
    });
  };
  const auto wrong_height = [&](const char* word, double (*height)(double v)) {
    wrong(word, [=](Place2 uv) { return at(turn(uv), radius(height(uv.v)), height(uv.v)); });
    wrong(word, [=](Place2 uv) { return at(turn(uv), radius(2 * uv.v - 1), height(uv.v)); });
  };
  wrong_radius(
      "the circle gets smaller toward the poles: your points are on the cylinder, not on the "
      "sphere",
      [](double) { return 1.; });
  wrong_radius(
      "the radius is sqrt(1 - y^2), by Pythagoras; with 1 - |y| the points are on two cones",
      [](double y) { return 1 - std::abs(y); });
  const char* square = "the radius is sqrt(1 - y * y): the length of the result must be 1";
  wrong_radius(square, [](double y) { return 1 - y * y; });
  wrong_radius(square, [](double y) { return std::sqrt(1 - y); });
  wrong_radius(square, [](double y) { return std::sqrt(1 + y * y); });
  wrong_radius(square, [](double y) { return 1 - y; });
  wrong_radius(square, [](double y) { return y; });
  wrong("the radius belongs to x and to z: multiply both", [=](Place2 uv) {
    const double y = 2 * uv.v - 1;
    return Vector{radius(y) * std::cos(turn(uv)), y, std::sin(turn(uv))};
  });
  wrong("the radius belongs to x and to z: multiply both", [=](Place2 uv) {
    const double y = 2 * uv.v - 1;
    return Vector{std::cos(turn(uv)), y, radius(y) * std::sin(turn(uv))};
  });
  wrong("a vector of length 1 is needed, but y must stay: do not normalize, take sqrt(1 - y * y)",
        [=](Place2 uv) { return normalize(at(turn(uv), 1, 2 * uv.v - 1)); });
  wrong_angle("std::cos and std::sin take radians: your angle is in degrees",
              [](double u) { return 360 * (0.5 - u); });
  wrong_angle("u runs the other way: your map is mirrored",
              [](double u) { return (u - 0.5) * 2 * pi; });
  wrong_angle("the half is missing: the angle is (1/2 - u) 2 pi (1 / 2 with int is 0)",
              [](double u) { return -u * 2 * pi; });
  wrong_angle("the angle is (1/2 - u) 2 pi: on u = 1/2 it is 0, and it falls with u",
              [](double u) { return u * 2 * pi; });
  wrong_angle("a whole turn is 2 pi: your picture covers half of the globe",
              [](double u) { return (0.5 - u) * pi; });
  wrong_angle("1/2 - u is a share of a turn: multiply it by 2 pi, do not divide",
              [](double u) { return (0.5 - u) / (2 * pi); });
  wrong_angle("1/2 - u is a share of a turn: multiply it by 2 pi",
              [](double u) { return 0.5 - u; });
  wrong_angle("* comes before -: write (0.5 - u) * 2 * pi",
              [](double u) { return 0.5 - u * 2 * pi; });
  wrong_height("v runs the other way: your map is upside down", [](double v) { return 1 - 2 * v; });
  wrong_height("v runs from 0 to 1, y from -1 to 1: the southern half is missing",
               [](double v) { return v; });
  wrong_height("y runs from -1/2 to 1/2: it is 2 v - 1", [](double v) { return v - 0.5; });
  wrong_height("y runs from -1 to 0: double v, then subtract 1", [](double v) { return v - 1; });
  wrong_height("y runs from -2 to 0: double v alone, then subtract 1",
               [](double v) { return 2 * (v - 1); });
  wrong_height("y runs from 0 to 2: subtract 1 from 2 v", [](double v) { return 2 * v; });
  wrong_height("this goes forward, from y to v: y is 2 v - 1",
               [](double v) { return (1 + v) / 2; });
  wrong("v is no latitude here, it is a height: yours goes back from the equirectangular layout",
        [](Place2 uv) { return direction_rtiow(uv); });
  wrong("x belongs to the cosine and z to the sine: yours are exchanged", [=](Place2 uv) {
    const double y = 2 * uv.v - 1;
    return Vector{radius(y) * std::sin(turn(uv)), y, radius(y) * std::cos(turn(uv))};
  });
  wrong("y is the height here, and z comes from the sine: yours are exchanged", [=](Place2 uv) {
    const double y = 2 * uv.v - 1;
    return Vector{radius(y) * std::cos(turn(uv)), radius(y) * std::sin(turn(uv)), y};
  });
  wrong("u and v are exchanged: u makes the angle, v the height", [=](Place2 uv) {
    const double y = 2 * uv.u - 1;
    return at((0.5 - uv.v) * 2 * pi, radius(y), y);
  });
  return mistakes;
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
      .mistakes = wrong_directions()};
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
