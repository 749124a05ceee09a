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

Slips<Place2> wrong_cylinders(Vector p) {
  const double y = p.y;
  const auto [u, v] = uv_cylinder(p);
  const double angle = std::atan2(p.z, p.x);
  const double from_x = std::atan2(p.x, p.z);
  const double whole = 2 * pi;
  Slips<Place2> wrong = changed(
      Slips<double>{
          {"v is the latitude here: that is the equirectangular layout. On the cylinder v is a "
           "height",
           {std::asin(y) / pi + 0.5, std::acos(y) / pi}},
          {"v runs the other way: your map is upside down", (1 - y) / 2},
          {"y runs from -1 to 1 and v from 0 to 1: the lower half is missing",
           {y, std::abs(y), std::max(y, 0.)}},
          {"v runs from 0 to 2: halve 1 + y", 1 + y},
          {"/ comes before +: write (1 + y) / 2", 1 + y / 2},
          {"v runs from -1/2 to 1/2: the half is missing (1 / 2 with int is 0)", y / 2},
          {"v runs from -1/2 to 3/2: y from -1 to 1 is twice as long as v, so halve it", 0.5 + y},
          {"this goes back, from v to y: v is (1 + y) / 2", 2 * y - 1},
      },
      [=, u = u](double wrong_v) {
        return Place2{u, wrong_v};
      });
  const Slips<double> wrong_u = {
      {"u runs the other way: your map is mirrored", 0.5 + angle / whole},
      {"std::atan2 returns radians: divide by 2 pi, not by 360", 0.5 - angle / 360},
      {"u begins at -1/2: the half is missing (1 / 2 with int is 0)", -angle / whole},
      {"u runs the other way, and begins at -1/2: it is 1/2 minus the share of a turn",
       angle / whole},
      {"a whole turn is 2 pi, not pi: u runs twice too far", 0.5 - angle / pi},
      {"/ 2 * pi divides by 2 and multiplies by pi: write / (2 * pi)", 0.5 - angle / 2 * pi},
      {"the angle is no share of a turn: divide it by 2 pi", 0.5 - angle},
      {"/ comes before -: divide the angle alone, and subtract it from 1/2", (0.5 - angle) / whole},
      {"u is off by 1/2: on +x it is 1/2, and the seam is on -x", 1 - angle / whole},
      {"std::atan2 takes z first, then x: your globe is turned and mirrored",
       {0.5 - from_x / whole, 0.5 + from_x / whole}},
      {"std::atan cannot tell the front from the back: take std::atan2(p.z, p.x)",
       0.5 - std::atan(p.z / p.x) / whole},
      {"y is the axis: the angle around it is std::atan2(p.z, p.x)",
       0.5 - std::atan2(y, p.x) / whole},
  };
  wrong += changed(wrong_u, [v = v](double other) { return Place2{other, v}; });
  wrong += changed(wrong_u, [=](double other) { return Place2{other, y}; });
  wrong += {{"u and v are exchanged: u goes around, v up", {v, u}}};
  return wrong;
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
      .slips = wrong_cylinders};
  return exercise("10.1", "Uv on_cylinder(Vec3 p)", std::move(law), on_cylinder,
                  [] { return globe("cylinder"); });
}

Place2 in_square(const Place2& at) { return {(1 + at.u) / 2, (1 + at.v) / 2}; }
/// (a, b) with its fold, as for the lower half.
Place2 folded_out(const Place2& at) {
  return {std::copysign(1 - std::abs(at.v), at.u), std::copysign(1 - std::abs(at.u), at.v)};
}

Slips<Place2> wrong_octahedra(Vector p) {
  const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
  const Place2 from_above{p.x / s, -p.z / s};
  const auto [a, b] = from_above;
  const double a_left = 1 - std::abs(a);
  const double b_left = 1 - std::abs(b);
  const Place2 right = folded_out(from_above);
  Slips<Place2> wrong = changed(
      Slips<Place2>{
          {"nothing is folded: the southern half lies on the northern one", from_above},
          {"the signs are missing: all lower faces land in the corner at the upper right",
           {b_left, a_left}},
          {"the signs are exchanged: a keeps the sign of a, b that of b",
           {std::copysign(b_left, b), std::copysign(a_left, a)}},
          {"the signs are turned around: a keeps its sign, and b keeps its sign",
           {-right.u, -right.v}},
          {"a needs 1 - |b|, and b needs 1 - |a|: the mirror exchanges them",
           {std::copysign(a_left, a), std::copysign(b_left, b)}},
          {"b is not folded: its new value needs the old a, so keep that in a variable",
           {right.u, std::copysign(1 - std::abs(right.u), b)}},
          {"the bars are missing: it is 1 - |b| and 1 - |a|, without signs",
           {(1 - b) * (a < 0 ? -1 : 1), (1 - a) * (b < 0 ? -1 : 1)}},
          {"the bars and the signs are missing: it is sign(a) (1 - |b|) and sign(b) (1 - |a|)",
           {1 - b, 1 - a}},
          {"the size of a counts twice: multiply by its sign, 1 or -1", {a * b_left, b * a_left}},
          {"1 + |b| leaves the square: it is 1 - |b| and 1 - |a|",
           {std::copysign(1 + std::abs(b), a), std::copysign(1 + std::abs(a), b)}},
          {"a is not folded: its new value needs the old b, so keep that in a variable",
           {a, right.v}},
      },
      [&](const Place2& fold) { return in_square(p.y < 0 ? fold : from_above); });
  /// From (x, -z) divided by this, or from another (a, b): folded where `y` is below 0.
  const auto folded = [](const Place2& at, double y) {
    return in_square(y < 0 ? folded_out(at) : at);
  };
  const auto by = [&](double sum) { return folded({p.x / sum, -p.z / sum}, p.y); };
  const auto [u, v] = uv_octahedral(p);
  wrong += {
      {"b is -z / s: yours is z / s, and north and south edges are exchanged",
       uv_octahedral(Vector{p.x, p.y, -p.z})},
      {"a is x / s: yours is -x / s, so west and east are exchanged",
       uv_octahedral(Vector{-p.x, p.y, p.z})},
      {"you fold where y is above 0: only the lower half is folded out", folded(from_above, -p.y)},
      {"you fold everywhere: only the lower half, y < 0, is folded out", folded(from_above, -1)},
      {"you fold where z is below 0: the lower half is where y < 0", folded(from_above, p.z)},
      {"divide by |x| + |y| + |z|, not by the length: the point must lie on the octahedron",
       by(length(p))},
      {"p may have any length: divide it by |x| + |y| + |z|", by(1)},
      {"the bars are missing in the sum: divide by |x| + |y| + |z|", by(p.x + p.y + p.z)},
      {"y is missing in the sum: divide by |x| + |y| + |z|", by(std::abs(p.x) + std::abs(p.z))},
      {"divide by the sum |x| + |y| + |z|, not by the largest of them: that is a cube",
       by(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}))},
      {"seen from above the place is (x, -z): you take y, as seen from the front",
       folded({a, p.y / s}, p.y)},
      {"a and b run from -1 to 1, u and v from 0 to 1: return (1 + a) / 2 and (1 + b) / 2",
       {{2 * u - 1, 2 * v - 1}, {u - 0.5, v - 0.5}, {2 * u, 2 * v}}},
      {"/ comes before +: write (1 + a) / 2 and (1 + b) / 2", {u + 0.5, v + 0.5}},
      {"u and v are exchanged: u comes from a, v from b", {v, u}},
  };
  return wrong;
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
      .slips = wrong_octahedra};
  return exercise("10.2", "Uv on_octahedron(Vec3 p)", std::move(law), on_octahedron,
                  [] { return globe("octahedral"); });
}

Slips<Vector> wrong_directions(Place2 uv) {
  const auto at = [](double angle, double radius, double y) {
    return Vector{radius * std::cos(angle), y, radius * std::sin(angle)};
  };
  const auto radius_at = [](double y) { return std::sqrt(1 - y * y); };
  const auto [u, v] = uv;
  const double turn = (0.5 - u) * 2 * pi;
  const double y = 2 * v - 1;
  const double radius = radius_at(y);
  const double x = radius * std::cos(turn);
  const double z = radius * std::sin(turn);
  const auto with_radius = [=](double other) { return at(turn, other, y); };
  const auto with_angle = [=](double other) { return at(other, radius, y); };
  /// With the radius at that height, and with the right one.
  const auto with_height = [=](double other) {
    return std::vector{at(turn, radius_at(other), other), at(turn, radius, other)};
  };
  return {
      {"the circle gets smaller toward the poles: your points are on the cylinder, not on the "
       "sphere",
       with_radius(1)},
      {"the radius is sqrt(1 - y^2), by Pythagoras; with 1 - |y| the points are on two cones",
       with_radius(1 - std::abs(y))},
      {"the radius is sqrt(1 - y * y): the length of the result must be 1",
       {with_radius(1 - y * y), with_radius(std::sqrt(1 - y)), with_radius(std::sqrt(1 + y * y)),
        with_radius(1 - y), with_radius(y)}},
      {"the radius belongs to x and to z: multiply both",
       {{x, y, std::sin(turn)}, {std::cos(turn), y, z}}},
      {"a vector of length 1 is needed, but y must stay: do not normalize, take sqrt(1 - y * y)",
       normalize(with_radius(1))},
      {"std::cos and std::sin take radians: your angle is in degrees", with_angle(360 * (0.5 - u))},
      {"u runs the other way: your map is mirrored", with_angle(-turn)},
      {"the half is missing: the angle is (1/2 - u) 2 pi (1 / 2 with int is 0)",
       with_angle(-u * 2 * pi)},
      {"the angle is (1/2 - u) 2 pi: on u = 1/2 it is 0, and it falls with u",
       with_angle(u * 2 * pi)},
      {"a whole turn is 2 pi: your picture covers half of the globe", with_angle(turn / 2)},
      {"1/2 - u is a share of a turn: multiply it by 2 pi, do not divide",
       with_angle((0.5 - u) / (2 * pi))},
      {"1/2 - u is a share of a turn: multiply it by 2 pi", with_angle(0.5 - u)},
      {"* comes before -: write (0.5 - u) * 2 * pi", with_angle(0.5 - u * 2 * pi)},
      {"v runs the other way: your map is upside down", with_height(-y)},
      {"v runs from 0 to 1, y from -1 to 1: the southern half is missing", with_height(v)},
      {"y runs from -1/2 to 1/2: it is 2 v - 1", with_height(v - 0.5)},
      {"y runs from -1 to 0: double v, then subtract 1", with_height(v - 1)},
      {"y runs from -2 to 0: double v alone, then subtract 1", with_height(2 * (v - 1))},
      {"y runs from 0 to 2: subtract 1 from 2 v", with_height(2 * v)},
      {"this goes forward, from y to v: y is 2 v - 1", with_height((1 + v) / 2)},
      {"v is no latitude here, it is a height: yours goes back from the equirectangular layout",
       direction_rtiow(uv)},
      {"x belongs to the cosine and z to the sine: yours are exchanged", {z, y, x}},
      {"y is the height here, and z comes from the sine: yours are exchanged", {x, z, y}},
      {"u and v are exchanged: u makes the angle, v the height",
       at((0.5 - v) * 2 * pi, radius_at(2 * u - 1), 2 * u - 1)},
  };
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
      .slips = wrong_directions};
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
      {onto_a_cylinder(), fold_an_octahedron(), back_from_the_cylinder()},
      {{"10.a",
        "An equal-area octahedral picture has 1024 x 1024 texels. How many texels must an "
        "equirectangular picture have, if its largest texel may cover no more of the globe "
        "than one texel of the first picture?",
        texels_needed, "texels", 2e-3},
       {"10.b",
        "You read an equirectangular file as if it were a cylinder's. At which latitude of the "
        "globe do you see what the file has at 45 degrees north?",
        latitude_by_cylinder, "degrees"}},
  };
  return chapter;
}

}  // namespace texmap::check
