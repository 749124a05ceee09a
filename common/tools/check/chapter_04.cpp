// The exercises of chapter 04. The lesson is the chapter's own. Its ConventionMapping is this one
// here, which calls the student's functions.
#include "exercises.hpp"
#include "texture/conventions.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::chapter_04 {

static std::function<Uv<double>(Vec3d, Vec3d, bool, bool)> uv_in;
static std::function<int(int, int)> old_column;
static std::function<bool(Vec3d, Vec3d, Vec3d, Uv<double>, Uv<double>, Uv<double>, bool)>
    is_mirrored;

/// Whether the student's function calls this convention mirrored. It gets a point that the picture
/// shows and its neighbors to the east and to the north.
static bool mirrors(Convention convention) {
  constexpr double step = 0.01;
  const auto place = [=](double u, double v) {
    return texmap::uv_of(convention, direction_rtiow(Uv<double>{u, v}));
  };
  return is_mirrored({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, place(0.3, 0.6), place(0.3 + step, 0.6),
                     place(0.3, 0.6 + step), v_axis_of(convention) == VAxis::up);
}

struct ConventionMapping {
  Convention convention = Convention::rtiow;

  Uv<double> operator()(const Vec3d& p) const {
    if (uv_in) return uv_in(p, {0, 0, 1}, false, false);
    const Uv<double> uv = texmap::uv_of(convention, p);
    return is_mirrored && mirrors(convention) ? Uv<double>{1 - uv.u, uv.v} : uv;
  }
};

// The lesson's own one draws a sheet, in all numbers. The exercises draw the stage alone.
struct Lesson;
static void show_conventions(const Lesson&, Session&) {}

}  // namespace texmap::chapter_04

#include "04_uv_conventions/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_04;

/// The daily exercise's globe.
Lesson daily_lesson(const char* texture) {
  return prepared<Lesson>({"--convention", "daily", "--texture", texture});
}

Slips<Place2> wrong_places(Vec3d p, Vec3d seam, bool to_east, bool to_north) {
  const double of_p = atan2(-p.z, p.x) / (2 * pi), of_seam = atan2(-seam.z, seam.x) / (2 * pi);
  const double turns = (to_east ? 1 : -1) * (of_p - of_seam), u = fraction(turns);
  const double south = acos(clamp(-p.y, -1., 1.)), up = south / pi, v = to_north ? up : 1 - up;
  const auto one_way = [=](double east) { return fraction(to_east ? east : -east); };
  const Slips<double> us = {
      {"u must be 0 at the seam: subtract the seam's longitude, and add no 1/2",
       {one_way(of_p), 0.5 + of_p, fraction(0.5 + of_p), one_way(0.5 + of_p), of_p,
        0.5 + (to_east ? of_p : -of_p), fraction(0.5 + turns), 0.5 + turns}},
      {"the seam's longitude has the wrong sign, or only one of the two is turned to the west",
       {one_way(of_p + of_seam), fraction((to_east ? of_p : -of_p) - of_seam)}},
      {"without its whole turns u is 0 to 1: subtract std::floor, as below 0 it must go up",
       {turns, fmod(turns, 1), turns + 1, abs(turns), abs(fmod(turns, 1)), clamp(turns, 0., 1.)}},
      {"u = 1 is the seam, where u must be 0: turn the longitudes around, not u at the end",
       to_east ? u : 1 - fraction(-turns)},
      {"u runs the other way: std::atan2(-p.z, p.x), with z first, grows to the east",
       fraction(-turns)},
      {"u_to_east says which way u grows", {fraction(of_p - of_seam), fraction(of_seam - of_p)}},
      {"the longitude is in radians: divide it by 2 pi",
       {fraction(2 * pi * turns), 2 * pi * turns, 2 * pi * u, fraction(2 * turns), 2 * u}},
  };
  const Slips<double> vs = {
      {"v runs the other way: std::acos(-p.y) is the angle from the south pole", 1 - v},
      {"v_to_north says which way v grows", {up, 1 - up}},
      {"v is the angle, and a part of 1: std::acos(-p.y) / pi",
       {to_north ? south : 1 - south, to_north ? (p.y + 1) / 2 : (1 - p.y) / 2,
        to_north ? south : pi - south, to_north ? up / 2 : 1 - up / 2}},
      {"at the pole acos and asin can be NaN: limit y to -1 and 1",
       (to_north ? acos(-p.y) : acos(p.y)) / pi},
  };
  const auto with_v = [=](double wrong) { return Place2{wrong, v}; };
  const auto with_u = [=](double wrong) { return Place2{u, wrong}; };
  return {changed(us, with_v), changed(vs, with_u)};
}

Place2 right_place(const Vec3d& p, Vec3d seam, bool to_east, bool to_north) {
  const double east = fraction(uv_rtiow(p).u - uv_rtiow(seam).u), v = uv_rtiow(p).v;
  return {to_east ? east : fraction(-east), to_north ? v : 1 - v};
}
constexpr Vec3d x_axis{1, 0, 0}, date_line{-1, 0, 0}, z_axis{0, 0, 1}, oblique{0.6, 0, -0.8};
constexpr Place<Vec3d, Vec3d, bool, bool> uv_in_places[] = {
    {"seam on -x, u east, v north: on +z, u is 1/4", {z_axis, date_line, true, true}},
    {"seam on -x, u west, v north: on +z, u is 3/4", {z_axis, date_line, false, true}},
    {"seam on +z, u east: on +x, u is 1/4", {x_axis, z_axis, true, true}},
    {"seam on +x, u east: on +z, u is 3/4", {z_axis, x_axis, true, false}},
    {"on the seam u is 0, not 1", {date_line, date_line, false, true}},
    {"v south: 45 degrees north of +x, v is 1/4", {{half_root, half_root, 0}, z_axis, true, false}},
    {"v north: there v is 3/4", {{half_root, half_root, 0}, z_axis, false, true}},
    {"seam on (0.6, 0, -0.8), u east, v north", {{-2. / 3, 1. / 3, 2. / 3}, oblique, true, true}},
    {"the same, u west, v south", {{-2. / 3, 1. / 3, 2. / 3}, oblique, false, false}},
    {"seam on (0.6, 0, -0.8), in the direction (-2, -1, -2) / 3",
     {{-2. / 3, -1. / 3, -2. / 3}, oblique, true, true}},
    {"v north: at the north pole v is 1, also where rounding made y more than 1",
     {{1e-12, 1 + 0x1p-52, 0}, x_axis, true, true}},
    {"v south: at the north pole v is 0, also where rounding made y more than 1",
     {{1e-12, 1 + 0x1p-52, 0}, x_axis, true, false}},
};

/// At a pole any u is right.
Place2 within_the_poles(const Place2& uv, const Vec3d& p, Vec3d /*seam*/, bool /*to_east*/,
                        bool /*to_north*/) {
  return {std::abs(p.y) < 1 ? uv.u : 0, uv.v};
}

/// The globe with the lecture's picture, whose columns the student moves.
Image globe_of_columns() {
  Lesson lesson = daily_lesson("earth.png");
  SharedImage& texels =
      std::get<Textured>(lesson.objects[middle].paint).texture.wrapped.texture.image;
  const SharedImage earth = texels;
  texels = image_of(earth.width, earth.height, [&](int column, int row) {
    const int old = old_column(column, earth.width);
    if (old < 0 || old >= earth.width) return Rgb8{255, 0, 255};
    return earth.at((old + earth.width / 4) % earth.width, row);
  });
  return picture_of(lesson, 18);
}

Slips<int> wrong_columns(int column, int w) {
  const int quarter = w / 4, east = w - 1 - column;
  const auto within = [=](int x) { return (x % w + w) % w; };
  return {
      {"column 0 of one is the last column, width - 1, of the other: you are one too far right",
       {within(w - column - quarter), within(w - column), w - column - quarter}},
      {"you are one too far left: columns are numbered from 0", within(east - quarter - 1)},
      {"left of column 0 is the last column again: add width there",
       {east - quarter, (east - quarter) % w, abs(east - quarter), max(east - quarter, 0)}},
      {"the quarter has the wrong sign: +z lies to the east of -x, so fewer columns are between",
       {within(east + quarter), east + quarter}},
      {"one picture runs east and the other west: the order of the columns is turned around",
       {within(column - quarter), within(column + quarter), column - quarter, column + quarter}},
      {"the order is right, but the two begin a quarter of the columns apart: width / 4", east},
  };
}

int right_column(int column, int width) {
  const Place2 daily{(column + 0.5) / width, 0.5};  // to rtiow and back is the same formula
  return int(in_convention(Convention::lecture, in_convention(Convention::daily, daily)).u * width);
}
constexpr Place<int, int> old_column_places[] = {
    {"of 8 columns, the new column 0 begins at -x: it is the old column 5", {0, 8}},
    {"of 8 columns, the new column 1 is the old column 4", {1, 8}},
    {"of 8 columns, the new column 5 ends at +z: it is the old column 0", {5, 8}},
    {"of 8 columns, the new column 6 is the old column 7", {6, 8}},
    {"of 8 columns, the new column 7 is the old column 6", {7, 8}},
    {"of 12 columns, the new column 3 is the old column 5", {3, 12}},
    {"of 4 columns, the new column 3 is the old column 3", {3, 4}},
    {"of 2048 columns, the new column 1800 is the old column 1783", {1800, 2048}},
};

/// The corners of a triangle: as one sees them, or of the texture.
using Corners = std::array<Place2, 3>;
double area(const Corners& c) {
  return (c[1].u - c[0].u) * (c[2].v - c[0].v) - (c[2].u - c[0].u) * (c[1].v - c[0].v);
}

Slips<bool> wrong_mirrors(Vec3d a, Vec3d b, Vec3d c, Place2 uv_a, Place2 uv_b, Place2 uv_c,
                          bool up) {
  const Corners seen{{{a.x, a.y}, {b.x, b.y}, {c.x, c.y}}}, texture{uv_a, uv_b, uv_c};
  const double sign = up ? 1 : -1;
  /// By another formula than the determinant; also with v always upward.
  const auto by = [=](auto of) {
    const double product = of(seen) * of(texture);
    return std::vector<bool>{sign * product < 0, product < 0};
  };
  const double right = sign * area(seen) * area(texture);
  return {
      {"v can grow downward on the print: there the determinant of (u, v) has the other sign",
       right * sign < 0},
      {"yes and no are exchanged, or v_upward is: opposite signs mean mirrored", right > 0},
      {"this is never true: mirrored is where two determinants have different signs", false},
      {"this is always true: mirrored is where two determinants have different signs", true},
      {"a, b and c can run clockwise where you see them: compare with their own determinant",
       {sign * area(texture) < 0, area(texture) < 0}},
      {"this looks at the globe alone: compare with the determinant of (u, v)",
       {area(seen) < 0, sign * area(seen) < 0}},
      {"these are places: subtract the first from the second and from the third",
       by([](const Corners& p) { return p[1].u * p[2].v - p[2].u * p[1].v; })},
      {"the determinant has two products, one minus the other: half of it is wrong if turned",
       by([](const Corners& p) { return (p[1].u - p[0].u) * (p[2].v - p[0].v); })},
      {"one step alone does not say it: the letters may be turned",
       by([](const Corners& p) { return p[1].u - p[0].u; })},
      {"v_upward alone does not say it: look at the corners, too", {up, !up}},
  };
}

/// Whether the way around the corners turns the same way on the globe and on the print.
bool right_mirrored(Vec3d a, Vec3d b, Vec3d c, Place2 uv_a, Place2 uv_b, Place2 uv_c, bool up) {
  const auto printed = [=](Place2 uv) { return Vec3d{uv.u, up ? uv.v : -uv.v, 0}; };
  return (cross(b - a, c - a).z < 0) !=
         (cross(printed(uv_b) - printed(uv_a), printed(uv_c) - printed(uv_a)).z < 0);
}

/// Steps from a to b and to c as one sees them, from (0.3, 0.2); and of (u, v), in hundredths.
constexpr std::tuple<Vec3d, Vec3d, Vec3d, Place2, Place2, Place2, bool> steps(
    Place2 to_b, Place2 to_c, Place2 uv_to_b, Place2 uv_to_c, bool up) {
  const auto seen = [](Place2 by) { return Vec3d{0.3 + by.u, 0.2 + by.v, 5}; };
  const auto uv = [](Place2 by) { return Place2{0.5 + 0.01 * by.u, 0.4 + 0.01 * by.v}; };
  return {seen({0, 0}), seen(to_b), seen(to_c), uv({0, 0}), uv(uv_to_b), uv(uv_to_c), up};
}
constexpr Place2 east{1, 0}, north{0, 1}, west{-1, 0};
constexpr Place<Vec3d, Vec3d, Vec3d, Place2, Place2, Place2, bool> is_mirrored_places[] = {
    {"b right with more u, c above with more v, v upward: no",
     steps(east, north, east, north, true)},
    {"b right with less u, c above with more v, v upward: yes",
     steps(east, north, west, north, true)},
    {"b right with more u, c above with more v, v downward",
     steps(east, north, east, north, false)},
    {"b right with less u, c above with more v, v downward",
     steps(east, north, west, north, false)},
    {"b above with more v, c right with more u, v upward: no",
     steps(north, east, north, east, true)},
    {"b above with more v, c right with less u, v upward: yes",
     steps(north, east, north, west, true)},
    {"b right with more v, c above with less u: a quarter turn",
     steps(east, north, north, west, true)},
    {"b right with more v, c above with more u, v upward: yes",
     steps(east, north, north, east, true)},
    {"all slanted, v upward", steps({1, 2}, {-1, 1}, {1, 2}, {2, 1}, true)},
    {"all slanted, v downward", steps({-2, 1}, {-1, -1}, {2, 1}, {1, 2}, false)},
    {"only (u, v) slanted, v upward", steps({1, 0}, {0, 1}, {1, -2}, {2, 1}, true)},
    {"only (u, v) slanted, v downward", steps({1, 0}, {0, 1}, {1, -2}, {2, 1}, false)},
    {"all slanted, c on the right", steps({1, 2}, {2, 1}, {-2, 1}, {-1, 1}, true)},
    {"all slanted, c on the left", steps({2, 1}, {1, 2}, {1, -2}, {-1, -1}, true)},
};

}  // namespace

ExercisesOfChapter all_exercises_of_chapter() {
  return {
      "04",
      {exercise(uv_in, [] { return picture_of(daily_lesson("earth.png"), 18); },
                {right_place, wrong_places, uv_in_places, within_the_poles}),
       exercise(old_column, globe_of_columns,
                {right_column,
                 wrong_columns,
                 old_column_places,
                 {},
                 [](int, int width) { return width; }}),
       exercise(is_mirrored, [] { return picture_of(daily_lesson("uv_map.png"), 18); },
                {right_mirrored, wrong_mirrors, is_mirrored_places})},
      {{"The Earth's map has 2048 columns. By how many columns does the lecture's rounding shift "
        "it at America, where u is 1/4?",
        [] { return 0.25 * 2048 - 0.25 * 2047; },
        {"columns", 1e-3},
        "The lecture multiplies u by 2047 in place of 2048.",
        {{0.5, "this is the shift where u is 1/2; America is at 1/4"}}},
       {"A place has u = 0.1 in the lecture's convention. What is its u in the daily exercise's?",
        [] {
          return in_convention(Convention::daily, Place2{0.1 + 0.25, 0.5}).u;
        },
        {"", 1e-3},
        "First find the course's u. Which of the two other conventions runs west?",
        {{0.15, "the quarter has the wrong sign: the lecture's u is that of the course less 1/4"},
         {0.35, "this is the course's u: the daily exercise's runs the other way"}}}},
  };
}

}  // namespace texmap::check
