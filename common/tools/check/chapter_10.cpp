// The exercises of chapter 10. The lesson's ProjectionMapping and ProjectionOptions are here
// structs that call the student's functions: to read the globe's picture, and to make it.
#include "10_projections/sheet.hpp"
#include "engine/run/projection_options.hpp"
#include "exercises.hpp"
#include "texture/projection_facts.hpp"

namespace texmap::chapter_10 {

static std::function<Uv<double>(Vec3d)> on_round_map, on_half_octahedron;
static std::function<Vec3d(Uv<double>)> direction_of;

struct ProjectionMapping {
  Projection projection = Projection::equirect;

  Uv<double> operator()(const Vec3d& p) const {
    if (on_round_map) return on_round_map(p);
    if (on_half_octahedron) return on_half_octahedron({p.x, std::abs(p.y), p.z});
    return project(projection, p);
  }
};

/// The direction at a place of the layout that an exercise is about.
inline Vec3d direction_at(Projection layout, Uv<double> uv) {
  if (direction_of) return direction_of(uv);
  if (!on_round_map && !on_half_octahedron) return unproject(layout, uv);
  const double right = 2 * uv.u - 1, up = 2 * uv.v - 1;
  const double square = right * right + up * up;
  if (on_round_map) {  // 2 at the rim
    const double out = 2 * std::sqrt(max(1 - square, 0.0));
    return {right * out, 1 - 2 * square, -up * out};
  }
  const double a = (right - up) / 2, b = (right + up) / 2;
  return {a, 1 - std::abs(a) - std::abs(b), -b};
}

struct ProjectionOptions : texmap::ProjectionOptions {
  /// The file in the globe's layout; smaller, which is enough for the picture of an exercise.
  [[nodiscard]] ImageTexture load(TextureFile& file) const {
    constexpr double middle = 0.5 + 1.0 / 512;  // 600 of these are on no edge of 2048 texels
    const ImageTexture earth{file.load()};
    const bool square = on_round_map || on_half_octahedron;
    const int height = square ? 600 : static_cast<int>(600 / facts_of(on_globe()).aspect);
    return {image_of(600, height, [&](int column, int row) {
      const Uv<double> uv{(column + middle) / 600, 1 - (row + middle) / height};
      const Rgb color = earth(uv_rtiow(direction_at(on_globe(), uv)));
      return Rgb8{byte_of(color.r), byte_of(color.g), byte_of(color.b)};
    })};
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

Place2 right_round(Vec3d p) {
  const double from_axis = std::hypot(p.x, p.z);
  if (from_axis == 0) return {p.y > 0 ? 0.5 : 1, 0.5};
  const double radius = sqrt((1 - p.y) / 8) / from_axis;
  return {0.5 + radius * p.x, 0.5 - radius * p.z};
}

Slips<Place2> wrong_rounds(Vec3d p) {
  const double y = p.y, from_axis = std::hypot(p.x, p.z), right = sqrt((1 - y) / 2);
  const double x = from_axis > 0 ? p.x / from_axis : 0, up = from_axis > 0 ? -p.z / from_axis : 0;
  const auto at = [=](double radius) {
    return Place2{0.5 + radius / 2 * x, 0.5 + radius / 2 * up};
  };
  const Slips<double> radii = {
      {"equal steps of the angle: areas near the rim are too large. Take equal areas",
       {acos(y) / pi, 0.5 - asin(y) / pi}},
      {"an area is the square of a radius: the root is missing", {(1 - y) / 2, 1 - y}},
      {"seen from above the south is below the north: this is the plane of the page", from_axis},
      {"the cap's share of the sphere is 2 pi (1 - y) / 4 pi, (1 - y) / 2",
       {sqrt(1 - y), sqrt(1 - abs(y)), sqrt((1 - y) / 4)}},
      {"the rim has the radius 1/2: your map does not fit the square", {2 * right, right / 2}},
      {"the south pole is in the middle of your map", sqrt((1 + y) / 2)},
  };
  const double r = right / 2;
  return {
      {"at the north pole itself 0 / 0 is no number: return the middle there",
       from_axis > 0 ? at(right) : Place2{0. / from_axis, 0. / from_axis}},
      changed(radii, at),
      {"(x, -z) is shorter than 1: divide it by its length",
       {{0.5 + r * p.x, 0.5 - r * p.z},
        {0.5 + right * p.x, 0.5 - right * p.z},
        {0.5 + r * x / max(from_axis, 1e-300), 0.5 + r * up / max(from_axis, 1e-300)}}},
      {"-z is up on the map: yours has +z there", {0.5 + r * x, 0.5 - r * up}},
      {"+x is to the right: your map is mirrored", {0.5 - r * x, 0.5 + r * up}},
      {"the middle of the map is at (1/2, 1/2): add 0.5",
       {{r * x, r * up}, {right * x, right * up}}},
  };
}

constexpr Place<Vec3d> on_round_map_places[] = {
    {"on +x, a quarter of a turn from the pole: half of the area lies inside", {{1, 0, 0}}},
    {"on -z it is straight up from the middle", {{0, 0, -1}}},
    {"at the north pole it is the middle, (1/2, 1/2)", {{0, 1, 0}}},
    {"at (-0.96, 0.28, 0): 0.36 of the area lies inside", {{-0.96, 0.28, 0}}},
    {"at (0, -0.28, 0.96): 0.64 of the area lies inside", {{0, -0.28, 0.96}}},
    {"in the direction (-2, 1, 2) / 3", {{-2. / 3, 1. / 3, 2. / 3}}},
};

Place2 right_half(Vec3d p) {
  const double s = abs(p.x) + abs(p.y) + abs(p.z);
  return {(1 + (p.x - p.z) / s) / 2, (1 - (p.x + p.z) / s) / 2};
}

Slips<Place2> wrong_half_octahedra(Vec3d p) {
  const double x = p.x, y = p.y, z = p.z, s = abs(x) + abs(y) + abs(z);
  const double a = x / s, b = -z / s, right = a + b, up = b - a;
  const auto at = [](double u, double v) { return Place2{(1 + u) / 2, (1 + v) / 2}; };
  const auto by = [&](double sum) { return at((x - z) / sum, (-x - z) / sum); };
  return {
      {"the square stands on its corner still: turn it, by an eighth of a turn", at(a, b)},
      {"a turn alone leaves the square too small: enlarge it by the root of 2",
       {at(right * half_root, up * half_root), at(right / 2, up / 2)}},
      {"it is too large: 1 to the right, before the turn, is 1 right and 1 down after it",
       at(right * 2 * half_root, up * 2 * half_root)},
      {"you turn it counterclockwise: +x has to go to the lower right corner", at(-up, right)},
      {"-z is up in the picture: b is -z / s", at(a - b, -b - a)},
      {"your sky is mirrored: +x goes to the lower right corner, -z to the upper right one",
       {at(up, right), at(right, -up), at(-right, up)}},
      {"divide by |x| + |y| + |z|, which brings the direction to the octahedron",
       {by(1), by(length(p)), by(x + y + z), by(abs(x) + abs(z)), by(max({abs(x), y, abs(z)}))}},
      {"u and v run from 0 to 1: return (1 + ...) / 2",
       {{right, up}, {right / 2, up / 2}, {1 + right, 1 + up}}},
  };
}

constexpr Place<Vec3d> on_half_octahedron_places[] = {
    {"the zenith, +y, is in the middle, (1/2, 1/2)", {{0, 1, 0}}},
    {"+x is in the lower right corner, (1, 0)", {{1, 0, 0}}},
    {"-z is in the upper right corner, (1, 1)", {{0, 0, -1}}},
    {"between them, at (1, 0, -1), it is the middle of the right side", {{1, 0, -1}}},
    {"(1, 1, 0) is halfway from the middle to the lower right corner", {{1, 1, 0}}},
    {"(-1, 2, 1): |x| + |y| + |z| is 4", {{-1, 2, 1}}},
    {"(-2, 5, -13), close to the horizon", {{-2, 5, -13}}},
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

ExercisesOfChapter all_exercises_of_chapter() {
  return {
      "10",
      {exercise(on_round_map, picture<Lesson>({"--projection", "octahedral"}, 18),
                {right_round, wrong_rounds, on_round_map_places}),
       exercise(on_half_octahedron, picture<Lesson>({"--projection", "octahedral"}, 18),
                {right_half, wrong_half_octahedra, on_half_octahedron_places}),
       exercise(direction_of, picture<Lesson>({"--projection", "cylinder"}, 18),
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
}

}  // namespace texmap::check
