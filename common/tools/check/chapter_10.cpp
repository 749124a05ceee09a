// The exercises of chapter 10. The lesson's ProjectionMapping and ProjectionOptions are here
// structs that call the student's functions: to read the globe's picture, and to make it.
#include "10_projections/sheet.hpp"
#include "engine/run/projection_options.hpp"
#include "exercises.hpp"
#include "map_mistakes.hpp"
#include "texture/projection_facts.hpp"

namespace texmap::chapter_10 {

static std::function<Uv<double>(Vec3d)> on_cylinder, on_octahedron;
static std::function<Vec3d(Uv<double>)> direction_of;

struct ProjectionMapping {
  Projection projection = Projection::equirect;

  Uv<double> operator()(const Vec3d& p) const {
    if (on_cylinder) return on_cylinder(p);
    if (on_octahedron) return on_octahedron(p);
    return project(projection, p);
  }
};

struct ProjectionOptions : texmap::ProjectionOptions {
  /// The file in the globe's layout; smaller, which is enough for the picture of an exercise.
  [[nodiscard]] ImageTexture load(TextureFile& file) const {
    const ImageTexture earth{file.load()};
    ImageTexture made{Image(600, static_cast<int>(600 / facts_of(on_globe()).aspect))};
    for (int i = 0; i < 600 * made.image.height; ++i) {
      const int column = i % 600, row = i / 600;
      const Uv<double> uv{(column + 0.5) / 600, 1 - (row + 0.5) / made.image.height};
      const Rgb color =
          earth(uv_rtiow(direction_of ? direction_of(uv) : unproject(on_globe(), uv)));
      made.image.at(column, row) = {byte_of(color.r), byte_of(color.g), byte_of(color.b)};
    }
    return made;
  }
};

struct Lesson;
/// The program's sheet of all layouts is not drawn here.
inline void show_projections(Lesson&, Session&) {}

}  // namespace texmap::chapter_10

#include "10_projections/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_10;

/// Draws the globe from near by, its picture in a layout.
std::function<Image()> globe(const char* layout) {
  return picture<Lesson>({"--projection", layout}, 18);
}

Slips<Place2> wrong_cylinders(Vec3d p) {
  const double y = p.y, out = std::hypot(p.x, p.z);
  const auto [u, v] = uv_cylinder(p);
  const Slips<double> wrong_v = {
      {"v is the latitude here: that is the equirectangular layout. On the cylinder v is a height",
       {asin(y) / pi + 0.5, acos(y) / pi}},
      {"v runs the other way: your map is upside down", (1 - y) / 2},
      {"p moves away from the axis, not from the center", {(1 + y / out) / 2, y / out}},
      {"v is (1 + y) / 2",
       {{"y runs from -1 to 1, and the lower half is missing", {y, abs(y), max(y, 0.)}},
        {"/ comes before +", 1 + y / 2},
        {"the half is missing (1 / 2 with int is 0)", y / 2},
        {"this goes back, from v to y", 2 * y - 1},
        {"yours does not run from 0 to 1", {1 + y, 0.5 + y, (y - 1) / 2}}}},
  };
  Slips<double> wrong_u = {"u runs the other way: your map is mirrored", 1 - u};
  for (const double z : {p.z, -p.z})
    wrong_u += wrong_us(p.x, y, z, {from_half, from_0}, wrong_halves);
  Slips<Place2> wrong = changed(wrong_v, [u = u](double it) { return Place2{u, it}; });
  return wrong += changed(wrong_u, [v = v](double it) { return Place2{it, v}; });
}

constexpr Place<Vec3d> on_cylinder_places[] = {
    {"on +x, u is 1/2 and v is 1/2", {{1, 0, 0}}},
    {"on +z, u is 1/4", {{0, 0, 1}}},
    {"on -z, u is 3/4", {{0, 0, -1}}},
    {"halfway between +x and +z, u is 3/8", {{half_root, 0, half_root}}},
    {"at the height 0.6, (0.8, 0.6, 0), v is 0.8", {{0.8, 0.6, 0}}},
    {"at the height -0.6 v is 0.2", {{0.8, -0.6, 0}}},
    {"at the north pole v is 1", {{0, 1, 0}}},
    {"in the direction (-2, 1, 2) / 3", {{-2. / 3, 1. / 3, 2. / 3}}},
};

Place2 in_square(const Place2& at) { return {(1 + at.u) / 2, (1 + at.v) / 2}; }
/// (a, b) with its fold, as for the lower half.
Place2 folded_out(const Place2& at) {
  return {copysign(1 - abs(at.v), at.u), copysign(1 - abs(at.u), at.v)};
}

Slips<Place2> wrong_octahedra(Vec3d p) {
  const double x = p.x, y = p.y, z = p.z;
  const double s = abs(x) + abs(y) + abs(z);
  const Place2 from_above{x / s, -z / s};
  const auto [a, b] = from_above;
  const double a_left = 1 - abs(a), b_left = 1 - abs(b);
  const Place2 right = folded_out(from_above);
  const Slips<Place2> folds = {
      {"nothing is folded: the southern half lies on the northern one", from_above},
      {"a and b become sign(a) (1 - |b|) and sign(b) (1 - |a|)",
       {{"the signs are missing", {b_left, a_left}},
        {"the signs are exchanged", {copysign(b_left, b), copysign(a_left, a)}},
        {"the signs are turned around", {-right.u, -right.v}},
        {"|a| and |b| are exchanged", {copysign(a_left, a), copysign(b_left, b)}},
        {"the bars are missing", {(1 - b) * (a < 0 ? -1 : 1), (1 - a) * (b < 0 ? -1 : 1)}},
        {"the bars and the signs are missing", {{1 - b, 1 - a}, {1 - a, 1 - b}}},
        {"exchanging a and b mirrors at the diagonal alone", {b, a}},
        {"the size of a counts twice, as a sign is 1 or -1", {a * b_left, b * a_left}},
        {"1 + |b| leaves the square", {copysign(1 + abs(b), a), copysign(1 + abs(a), b)}},
        {"std::copysign takes the size first", {abs(a), abs(b)}}}},
      {"b is not folded: its new value needs the old a, so keep that in a variable",
       {right.u, copysign(1 - abs(right.u), b)}},
      {"a is not folded: its new value needs the old b, so keep that in a variable", {a, right.v}},
  };
  /// From (x, -z) divided by this, or from another (a, b): folded where `sign` is below 0.
  const auto folded = [](const Place2& at, double sign) {
    return in_square(sign < 0 ? folded_out(at) : at);
  };
  const auto by = [&](double sum) { return folded({x / sum, -z / sum}, y); };
  const auto [u, v] = uv_octahedral(p);
  return {
      changed(folds, [&](const Place2& fold) { return in_square(y < 0 ? fold : from_above); }),
      {"b is -z / s, not z / s: north and south are exchanged", uv_octahedral(Vec3d{x, y, -z})},
      {"a is x / s, not -x / s: west and east are exchanged", uv_octahedral(Vec3d{-x, y, z})},
      {"you fold elsewhere, too: only the lower half, y < 0, is folded out",
       {folded(from_above, -y), folded(from_above, -1), folded(from_above, z)}},
      {"divide by |x| + |y| + |z|",
       {{"the point must be brought to the octahedron",
         {by(1), by(length(p)), by(max({abs(x), abs(y), abs(z)}))}},
        {"the bars or y are missing in the sum", {by(x + y + z), by(abs(x) + abs(z))}}}},
      {"from above the place is (x, -z): you take y, as from the front", folded({a, y / s}, y)},
      {"a and b run from -1 to 1, u and v from 0 to 1: return (1 + a) / 2 and (1 + b) / 2",
       {{2 * u - 1, 2 * v - 1}, {u - 0.5, v - 0.5}, {2 * u, 2 * v}, {u + 0.5, v + 0.5}}},
  };
}

constexpr Place<Vec3d> on_octahedron_places[] = {
    {"the north pole +y is in the middle, (1/2, 1/2)", {{0, 1, 0}}},
    {"+x is in the middle of the right edge, (1, 1/2)", {{1, 0, 0}}},
    {"+z is in the middle of the lower edge, (1/2, 0)", {{0, 0, 1}}},
    {"halfway between +x and +y, at (1, 1, 0), u is 3/4", {{1, 1, 0}}},
    {"(1, 2, 1): |x| + |y| + |z| is 4, so u is 5/8 and v is 3/8", {{1, 2, 1}}},
    {"(-3, 4, -5), still on the upper half", {{-3, 4, -5}}},
    {"(4, -2, 2) is on the lower half: a = 1/2 and b = -1/4 become 3/4 and -1/2", {{4, -2, 2}}},
    {"(-4, -2, 2) is mirrored to the left: a becomes -3/4", {{-4, -2, 2}}},
    {"(1, -2, -5), on the lower half behind", {{1, -2, -5}}},
    {"(-1, -8, 3), close to the south pole: close to a corner", {{-1, -8, 3}}},
};

Slips<Vec3d> wrong_directions(Place2 uv) {
  const auto at = [](double angle, double radius, double y) {
    return Vec3d{radius * cos(angle), y, radius * sin(angle)};
  };
  const auto radius_at = [](double y) { return sqrt(1 - y * y); };
  const auto [u, v] = uv;
  const double turn = (0.5 - u) * 2 * pi, y = 2 * v - 1, radius = radius_at(y);
  const auto [x, height, z] = at(turn, radius, y);
  const auto by_radius = [=](double other) { return at(turn, other, y); };
  const Slips<double> angles = {
      {"std::cos and std::sin take radians: your angle is in degrees", 360 * (0.5 - u)},
      {"u runs the other way: your map is mirrored", -turn},
      {"a whole turn is 2 pi: your picture covers half of the globe", turn / 2},
      {"the angle is (0.5 - u) * 2 * pi",
       {{"the half is missing (1 / 2 with int is 0)", {-u * 2 * pi, u * 2 * pi}},
        {"multiply by 2 pi, do not divide", (0.5 - u) / (2 * pi)},
        {"2 pi is missing", 0.5 - u},
        {"* comes before -", 0.5 - u * 2 * pi}}},
  };
  const Slips<double> heights = {
      {"v runs the other way: your map is upside down", -y},
      {"the height y is 2 v - 1",
       {{"the southern half is missing", v},
        {"yours does not run from -1 to 1", {v - 0.5, v - 1, 2 * (v - 1), 2 * v}},
        {"this goes forward, from y to v", (1 + v) / 2}}},
  };
  return {
      {"the circle is smaller at the poles: yours is not on the sphere", by_radius(1)},
      {"the radius is sqrt(1 - y * y)",
       {{"with 1 - |y| the points are on two cones", by_radius(1 - abs(y))},
        {"the length of the result must be 1",
         {by_radius(1 - y * y), by_radius(sqrt(1 - y)), by_radius(sqrt(1 + y * y)),
          by_radius(1 - y), by_radius(y)}},
        {"multiply both x and z by it", {{x, y, sin(turn)}, {cos(turn), y, z}}},
        {"y must stay, so do not normalize", normalize(by_radius(1))},
        {"y is a height, no angle", {by_radius(cos(y)), at(turn, cos(y), sin(y))}}}},
      changed(angles, [=](double other) { return at(other, radius, y); }),
      // With the radius at that height, and with the right one.
      changed(heights, [=](double other) { return at(turn, radius_at(other), other); }),
      changed(heights, [=](double other) { return at(turn, radius, other); }),
      {"v is a height: yours goes back from the equirectangular layout", direction_rtiow(uv)},
      {"u and v are exchanged: u makes the angle, v the height",
       at((0.5 - v) * 2 * pi, radius_at(2 * u - 1), 2 * u - 1)},
  };
}

Vec3d right_direction(Place2 uv) { return unproject(Projection::cylinder, uv); }
constexpr Place<Place2> direction_of_places[] = {
    {"at (1/2, 1/2) is +x", {{0.5, 0.5}}},
    {"at (1/4, 1/2) is +z", {{0.25, 0.5}}},
    {"at (3/4, 1/2) is -z", {{0.75, 0.5}}},
    {"at (3/8, 1/2) is the point halfway between +x and +z", {{0.375, 0.5}}},
    {"the upper edge, v = 1, is the north pole everywhere", {{0.25, 1}}},
    {"at (1/2, 0.8) the height is 0.6 and x is 0.8", {{0.5, 0.8}}},
    {"at (1/2, 0.2) the height is -0.6", {{0.5, 0.2}}},
    {"at (0.1, 0.9)", {{0.1, 0.9}}},
};

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      "10",
      {exercise(on_cylinder, globe("cylinder"),
                {uv_cylinder<double>, wrong_cylinders, on_cylinder_places}),
       exercise(on_octahedron, globe("octahedral"),
                {uv_octahedral<double>, wrong_octahedra, on_octahedron_places}),
       exercise(direction_of, globe("cylinder"),
                {right_direction, wrong_directions, direction_of_places})},
      {{"An equal-area octahedral picture has 1024 x 1024 texels. How many texels must an "
        "equirectangular picture have, if its largest texel may cover no more of the globe than "
        "one texel of the first picture?",
        [] {  // its largest texels are on the equator
          return ceil(1024 * 1024 * distortion(Projection::equirect, Vec3d{0.8, 0, 0.6}).area);
        },
        {"texels", 2e-3},
        "How large is an equirectangular picture's largest texel, compared to the mean of all?",
        {{1048576,
          "as many texels would have that size in the mean: those at the equator are larger"},
         {2097152, "the shape 2 : 1 does not matter: compare the largest texel with the mean"}}},
       {"You read an equirectangular file as if it were a cylinder's. At which latitude of the "
        "globe do you see what the file has at 45 degrees north?",
        [] {
          const double v = uv_rtiow(Vec3d{1, 1, 0}).v;
          return asin(unproject(Projection::cylinder, Place2{0.5, v}).y) / radian;
        },
        {"degrees", 1e-3},
        "Which v has 45 degrees north in the file, and at which height does the cylinder read it?",
        {{63.64, "this goes the other way: what does the file have that is seen at 45 degrees"}}}},
  };
  return chapter;
}

}  // namespace texmap::check
