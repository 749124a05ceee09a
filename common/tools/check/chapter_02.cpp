// The exercises of chapter 02. The lesson is the chapter's own. It uses RtiowMapping and
// Checkerboard by name; here those names, in the lesson's namespace, mean structs that call the
// student's function.
#include "exercises.hpp"
#include "texture/checkerboard.hpp"
#include "texture/mapped.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::chapter_02 {

static std::function<Uv<double>(Vec3d)> uv_of;
static std::function<Vec3d(Vec3d, Vec3d, double, double, double)> after_walk;
static std::function<Uv<double>(Uv<double>, int)> as_bricks;

struct RtiowMapping {
  Uv<double> operator()(const Hit<double>& hit) const {
    if (uv_of) return uv_of(hit.normal);
    const Uv<double> uv = uv_rtiow(hit.normal);
    if (!after_walk) return uv;
    // As on a sphere somewhere else: to the east, and half of the way to the equator.
    const Vec3d center{4, -1, 2};
    const Vec3d start = center + hit.normal * 3.0;
    return uv_rtiow(after_walk(start, center, 3, 0.03, (0.5 - uv.v) / 2) - center);
  }
};

struct Checkerboard {
  Rgb even, odd;
  double squares = 10;

  Rgb operator()(const Uv<double>& uv) const {
    const Uv<double> place = as_bricks ? as_bricks(uv, int(squares)) : uv;
    return texmap::Checkerboard{even, odd, squares}(place);
  }
};

}  // namespace texmap::chapter_02

#include "02_checkerboard_uv/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_02;

// A map's u from a share of a turn to the east, 0 on +x: the right one, and two of those who make
// another mistake, too.
double below_0_added(double share) { return share < 0 ? share + 1 : share; }
double as_it_is(double share) { return share; }
double as_on_the_page(double share) { return 0.5 + share; }
constexpr std::array begins{below_0_added, as_it_is, as_on_the_page};

Slips<double> wrong_beginnings(double share) {
  const double angle = share * 2 * pi;
  const auto added = [=](double west) { return share < 0 ? share + west : share; };
  return {
      {"your map begins on -x, as the page's: this one begins on +x", {0.5 + share, share - 0.5}},
      {"add 1 only where the longitude is below 0",
       {{"west of Greenwich your u is below 0", {share, fmod(share, 1)}},
        {"u is 0 on +x, not 1", share <= 0 ? share + 1 : share},
        {"u is less than 1", share + 1},
        {"without its sign, west counts as east, and half of the map is mirrored", abs(share)},
        {"the west belongs to the right half of the map, so do not limit u", max(share, 0.0)},
        {"a whole turn is missing there",
         {added(0.5), added(2 * pi), added(360), added(1) * 2 * pi, added(1) * pi * pi,
          (share < 0 ? angle + 1 : angle) / (2 * pi), (share < 0 ? angle + 360 : angle) / (2 * pi),
          share < 0 ? 1 - share : share, share < 0 ? 0.5 - share : share}}}},
  };
}

/// Wrong u of the point (x, y, z).
Slips<double> wrong_us(double x, double y, double z) {
  constexpr double turn = 2 * pi;
  const auto share = [](double sine, double cosine) { return atan2(sine, cosine) / turn; };
  const double longitude = atan2(-z, x);
  constexpr auto precedence = "C++ reads a / 2 * pi as (a / 2) * pi: write a / (2 * pi)";
  constexpr auto radians = "u is in radians: divide the angle by 2 pi";
  const Slips<double> shares = {
      {precedence, longitude / 2 * pi},
      {radians, longitude},
      {"divide the radians by 2 pi",
       {{"a whole turn is not 360", longitude / 360},
        {"u is a part of 1, not degrees", longitude / radian},
        {"by pi alone the map goes around twice", longitude / pi}}},
      {"the arguments of atan2 are exchanged (z comes first), or u begins a quarter turn away",
       {share(x, z), -share(x, z)}},
      {"y goes up: the longitude is an angle between x and z",
       {share(-y, x), share(x, -y), share(-z, -y), share(y, x), share(x, y), share(-z, y)}},
      {"std::atan sees only z / x, half of the globe: use std::atan2", atan(-z / x) / turn},
  };
  Slips<double> us = wrong_beginnings(longitude / turn);
  us += {
      {precedence, (longitude + pi) / 2 * pi},
      {radians, longitude + pi},
      {"u is the same everywhere: in C++ 1 / 2 is 0, and 0 * angle is 0", begins.front()(0)},
  };
  for (const auto& begin : begins) us += changed(shares, begin);
  return us;
}

/// Wrong (u, v) of the point (x, y, z), as many write them.
Slips<Place2> map_slips(double x, double y, double z) {
  const auto v_by = [](double cosine) { return acos(clamp(cosine, -1.0, 1.0)) / pi; };
  const double north = asin(y), south = acos(-y);
  const double u = begins.front()(atan2(-z, x) / (2 * pi)), v = south / pi;
  const Slips<double> vs = {
      {"v is 0 on the equator, and has to be 1/2 there: add 0.5 (in C++ 1 / 2 is 0)", north / pi},
      {"divide the radians by pi",
       {{"v is in radians", {south, 1 - south}},
        {"half a turn is not 180", {south / 180, 0.5 + north / 180}},
        {"v is a part of 1, not degrees", south / radian},
        {"acos and asin run over half a turn", {south / (2 * pi), 0.5 + north / (2 * pi)}}}},
      {"v grows with the angle, not with the height y: take acos or asin", {(y + 1) / 2, y}},
      {"y is the axis from pole to pole: v comes from y", {v_by(x), v_by(-x), v_by(z), v_by(-z)}},
      {"limit y to -1 and 1, not to 0 and 1: half of the globe has negative y", v_by(max(-y, 0.0))},
      {"v is below 0 everywhere but at a pole: take the minus away", -v},
      {"the square root is missing in v: the distance from the axis is sqrt(x * x + z * z)",
       atan2(x * x + z * z, -y) / pi},
  };
  Slips<Place2> table = {"u and v are exchanged", {v, u}};
  table += changed(wrong_us(x, y, z), [&](double wrong) { return Place2{wrong, v}; });
  return table += changed(vs, [&](double wrong) { return Place2{u, wrong}; });
}

/// The same for those who have a sign wrong or do not limit y, for acos and asin, too.
Slips<Place2> map_slips(const Vec3d& p) {
  Slips<Place2> table;
  for (const double y : {p.y, -p.y}) {
    for (const double z : {p.z, -p.z}) {
      for (const double limited : {clamp(y, -1.0, 1.0), y}) table += map_slips(p.x, limited, z);
    }
  }
  return table;
}

Place2 right_place(const Vec3d& p) {
  const auto [u, v] = uv_rtiow(p);
  return {fraction(u + 0.5), v};
}

Slips<Place2> wrong_places(Vec3d p) {
  const auto [u, v] = right_place(p);
  const double west = fraction(1 - u), by_acos = acos(-p.y) / pi;  // the textbook's v
  return {
      {"at the pole acos and asin can be NaN: limit y to -1 and 1, or use atan2", {u, by_acos}},
      {"u runs the other way: your map is mirrored", {{west, v}, {west, by_acos}}},
      {"v runs the other way: your map is upside down", {{u, 1 - v}, {u, 1 - by_acos}}},
      map_slips(p),
  };
}

constexpr Place<Vec3d> uv_of_places[] = {
    {"on +x, u is 0 and v is 1/2", {{1, 0, 0}}},
    {"on +z, u is 3/4", {{0, 0, 1}}},
    {"on -z, u is 1/4", {{0, 0, -1}}},
    {"halfway between +x and +z, u is 7/8", {{half_root, 0, half_root}}},
    {"45 degrees north of -z, v is 3/4", {{0, half_root, -half_root}}},
    {"45 degrees south of -z, v is 1/4", {{0, -half_root, -half_root}}},
    {"in the direction (-2, 1, 2) / 3", {{-2. / 3, 1. / 3, 2. / 3}}},
    {"in the direction (2, -1, -2) / 3", {{2. / 3, -1. / 3, -2. / 3}}},
    {"in the direction (-2, -1, -2) / 3", {{-2. / 3, -1. / 3, -2. / 3}}},
    {"at the north pole v is 1, also where rounding made y more than 1", {{1e-12, 1 + 0x1p-52, 0}}},
    {"at the south pole v is 0, also where rounding made y less than -1",
     {{1e-12, -1 - 0x1p-52, 0}}},
};
/// At a pole any u is right.
Place2 within_the_poles(const Place2& uv, const Vec3d& p) {
  return {std::abs(p.y) < 1 ? uv.u : 0, uv.v};
}

Vec3d right_walk(Vec3d p, Vec3d center, double radius, double du, double dv) {
  const Place2 uv = uv_rtiow(p - center);
  return center + direction_rtiow(Place2{uv.u + du, uv.v + dv}) * radius;
}
/// With this function from -y to the angle from the south pole.
Slips<Vec3d> wrong_walks(Vec3d p, Vec3d center, double radius, double du, double dv,
                         double (*from_south)(double down)) {
  const auto uv = [=](const Vec3d& d) {
    return Place2{0.5 - atan2(d.z, d.x) / (2 * pi), from_south(-d.y) / pi};
  };
  const auto on = [=](const Vec3d& direction) { return center + direction * radius; };
  const auto walk = [&](const Vec3d& d, double east, double north) {
    const auto [u, v] = uv(d);
    return direction_rtiow(Place2{u + east, v + north});
  };
  const Vec3d away = p - center, d = away * (1 / radius), to = walk(d, du, dv);
  const auto [u, v] = uv(d);
  const auto from = [&](double other_u, double other_v) {
    return on(direction_rtiow(Place2{other_u + du, other_v + dv}));
  };
  /// By the angles phi and theta, and this distance from the axis.
  const auto by = [=](double phi, double theta, double wide) {
    return on({-wide * cos(phi), -cos(theta), wide * sin(phi)});
  };
  const double phi = 2 * pi * (u + du), theta = pi * (v + dv);
  Slips<Vec3d> wrong;
  for (const Vec3d& start : {p * (1 / radius), p, p * (1 / length(p))}) {
    const Vec3d arrived = walk(start, du, dv);
    wrong += {"subtract the center from p first, and add it to the place at the end",
              {on(arrived), arrived * radius, arrived}};
  }
  return {
      wrong,
      {"subtract the center from p first, and add it to the place at the end", {to * radius, to}},
      {"the formulas are for radius 1: divide p - center by the radius, multiply at the end",
       {on(walk(away, du, dv)), center + to, center + walk(away, du, dv)}},
      {"you go west: u grows to the east", on(walk(d, -du, dv))},
      {"you go south: v grows to the north", {on(walk(d, du, -dv)), on(walk(d, -du, -dv))}},
      {"u runs from 0 to 1 in a whole turn, 2 pi, and v in half a turn, pi",
       {on(walk(d, du / 2, dv)), on(walk(d, du / (2 * pi), dv)), on(walk(d, du / 360, dv)),
        from(u + 0.5 - atan2(d.z, d.x) / (2 * pi), v), on(walk(d, du, 2 * dv)),
        on(walk(d, du, dv / pi)), on(walk(d, du, dv / 180)), from(u, pi * v), from(u, v / 2),
        by(u + du, v + dv, sin(v + dv)), by(pi * (u + du), theta, sin(theta))}},
      {"x and z lack the factor sin(pi v): your ant leaves the sphere", by(phi, theta, 1)},
      {"v grows with the angle from the south pole, and not with the height",
       {from(u, (d.y + 1) / 2), on({to.x, d.y + 2 * dv, to.z}), on({to.x, d.y + dv, to.z}),
        on({to.x, 2 * (v + dv) - 1, to.z})}},
      {"std::atan sees only z / x, half of the globe: use std::atan2",
       from(0.5 - atan(d.z / d.x) / (2 * pi), v)},
      {"with du = dv = 0 yours is not p: one of the ways has another sign, or lacks the 1/2",
       {from(u + 0.5, v), on({to.x, to.y, -to.z}), on({-to.x, to.y, to.z}), from(-u, v),
        on({to.x, -to.y, to.z}), from(u, 1 - v), from(0.5 - atan2(d.x, d.z) / (2 * pi), v),
        on({to.z, to.y, to.x})}},
      {"u goes on beyond the edge of the map: do not limit it",
       by(2 * pi * clamp(u + du, 0., 1.), theta, sin(theta))},
  };
}
Slips<Vec3d> wrong_or_not_limited(Vec3d p, Vec3d center, double radius, double du, double dv) {
  const double not_a_number_at_the_pole = 0 * acos((p.y - center.y) / radius);
  return {
      {"at the pole acos and asin can be NaN: limit y to -1 and 1, or use atan2",
       right_walk(p, center, radius, du, dv) * (1 + not_a_number_at_the_pole)},
      wrong_walks(p, center, radius, du, dv, [](double y) { return acos(clamp(y, -1., 1.)); }),
      wrong_walks(p, center, radius, du, dv, [](double y) { return acos(y); }),
  };
}
constexpr Vec3d zero{0, 0, 0}, off{1, 2, 3};
constexpr Place<Vec3d, Vec3d, double, double, double> after_walk_places[] = {
    {"from +x, a quarter of the map to the east is -z", {{1, 0, 0}, zero, 1, 0.25, 0}},
    {"from +x, a quarter of it to the north is 45 degrees", {{1, 0, 0}, zero, 1, 0, 0.25}},
    {"with the radius 2, from (2, 0, 0) to (0, 0, -2)", {{2, 0, 0}, zero, 2, 0.25, 0}},
    {"around (1, 2, 3), from (3, 2, 3) to (1, 2, 1)", {{3, 2, 3}, off, 2, 0.25, 0}},
    {"from +z, 1/2 to the west is -z, across the seam", {{0, 0, 1}, zero, 1, -0.5, 0}},
    {"from 45 degrees north of -z to 45 south of -x",
     {{0, half_root, -half_root}, zero, 1, 0.25, -0.5}},
    {"around (4, -1, 2), radius 3, from (2, 0, 4)", {{2, 0, 4}, {4, -1, 2}, 3, 0.1, 0.2}},
    {"the north pole stays, also where rounding made y more than 1",
     {{1e-12, 1 + 0x1p-52, 0}, zero, 1, 0.25, 0}},
    {"the south pole stays, too", {{1e-12, -1 - 0x1p-52, 0}, zero, 1, 0.25, 0}},
};

Place2 right_bricks(Place2 uv, int squares) {
  const bool odd = fmod(floor(uv.v * squares), 2) == 1;
  return {uv.u + (odd ? 0.5 / squares : 0), uv.v};
}

Slips<Place2> wrong_bricks(Place2 uv, int squares) {
  const auto [u, v] = uv;
  const double half = 0.5 / squares;
  const auto moved = [=, u = u, v = v](double row, double by) {
    return Place2{fmod(row, 2) == 1 ? u + by : u, v};
  };
  const double row = floor(v * squares), right = moved(row, half).u;
  const bool stays = right == u;
  return {
      {"nothing is moved; what you add may be 0: 1 / 2, 1 / squares and int(v) are 0", uv},
      {"these bricks begin further east: take the color of u + 1/2 brick", moved(row, -half)},
      {"half a brick is 0.5 / squares",
       {{"a whole brick exchanges the colors", moved(row, 2 * half)},
        {"u is a part of 1", {moved(row, 0.5), moved(row, half / 2)}},
        {"there are `squares` rows and columns, not always 10",
         {moved(row, 0.05), moved(floor(10 * v), half), moved(floor(10 * v), 0.05)}},
        {"it is added to u, and u is not multiplied or divided",
         {{stays ? u : u / 2, v}, {stays ? u : u * half, v}, {stays ? u : half, v}}}}},
      {"rows 1, 3, 5 ... are moved, and 0, 2, 4 ... stay as they are",
       {{"all rows are moved", {u + half, v}},
        {"row 0 stays", moved(row + 1, half)},
        {"each row is moved more than the one below", {u + row * half, v}},
        {"this moves every second column, not row", moved(floor(u * squares), half)},
        {"rows begin at whole numbers, no rounding", moved(round(v * squares), half)}}},
      {"bricks move along u, not v", {{u, right - u + v}, {right, v + right - u}, {right, row}}},
      {"u goes around once in a turn: the checkerboard itself multiplies by its squares",
       {{stays ? u : right * squares, v}, {right * squares, v * squares}, {u * squares, v}}},
  };
}

/// The pattern is the same two squares further.
Place2 within_two_squares(const Place2& uv, Place2 /*from*/, int squares) {
  return {fraction(uv.u * squares / 2) * 2 / squares, uv.v};
}
constexpr Place<Place2, int> as_bricks_places[] = {
    {"with 10 squares, (0.32, 0.05) is in row 0: it stays as it is", {{0.32, 0.05}, 10}},
    {"(0.32, 0.13) is in row 1: half a brick is 0.05, and u becomes 0.37", {{0.32, 0.13}, 10}},
    {"also in the upper half of row 1, at (0.32, 0.18)", {{0.32, 0.18}, 10}},
    {"(0.32, 0.25) is in row 2: it stays as it is", {{0.32, 0.25}, 10}},
    {"(0.58, 0.35) is in row 3: u becomes 0.63", {{0.58, 0.35}, 10}},
    {"in row 9, u = 0.98 becomes 1.03: it may be more than 1", {{0.98, 0.93}, 10}},
    {"with 4 squares, (0.32, 0.35) is in row 1: u becomes 0.445", {{0.32, 0.35}, 4}},
    {"with 4 squares, (0.6, 0.65) is in row 2: it stays as it is", {{0.6, 0.65}, 4}},
    {"with 16 squares, (0.12, 0.6) is in row 9", {{0.12, 0.6}, 16}},
};

}  // namespace

ExercisesOfChapter all_exercises_of_chapter() {
  return {
      "02",
      {exercise(chapter_02::uv_of, picture<Lesson>(),
                {right_place, wrong_places, uv_of_places, within_the_poles}),
       exercise(after_walk, picture<Lesson>(),
                {right_walk, wrong_or_not_limited, after_walk_places}),
       exercise(as_bricks, picture<Lesson>({}, 22),
                {right_bricks, wrong_bricks, as_bricks_places, within_two_squares})},
      {{"On the equator a square of the checkerboard is twice as wide as it is high. At which "
        "latitude, in degrees, is it as wide as it is high?",
        [] { return acos(0.5) / radian; },
        {"degrees", 1e-3},
        "A square is as high everywhere. How long is the circle of a latitude, compared to the "
        "equator?",
        {{30, "there the circle is cos 30 = 0.87 times as long as the equator, not half"}}},
       {"With 9 squares in place of 10: how long is the longest piece of one color on the equator, "
        "in degrees?",
        [] { return 2 * 360. / 9; },
        {"degrees", 1e-3},
        "Which columns are neighbors at the seam, and which colors have they?",
        {{40, "this is one column: at the seam two columns of the same color meet"}}}},
  };
}

}  // namespace texmap::check
