// The exercises of chapter 02. The lesson is the chapter's own. It uses RtiowMapping and
// Checkerboard by name; here those names, in the lesson's namespace, mean structs that call the
// student's function.
#include "exercises.hpp"
#include "map_mistakes.hpp"
#include "texture/checkerboard.hpp"
#include "texture/mapped.hpp"

namespace texmap::chapter_02 {

static std::function<Uv<double>(Vec3d)> uv_of;
static std::function<bool(double, double, double)> is_first_color;
static std::function<Uv<double>(Uv<double>, int)> as_bricks;

struct RtiowMapping {
  Uv<double> operator()(const Hit<double>& hit) const {
    if (is_first_color) return {hit.point.x, hit.point.z};
    return uv_of ? uv_of(hit.normal) : uv_rtiow(hit.normal);
  }
};

struct Checkerboard {
  Rgb even, odd;
  double squares = 10;

  Rgb operator()(const Uv<double>& uv) const {
    if (is_first_color) return is_first_color(uv.u, uv.v, 0.75) ? even : odd;
    const Uv<double> place = as_bricks ? as_bricks(uv, int(squares)) : uv;
    return texmap::Checkerboard{even, odd, squares}(place);
  }
};

}  // namespace texmap::chapter_02

#include "02_checkerboard_uv/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_02;

double below_0_added(double share) { return share < 0 ? share + 1 : share; }
double as_it_is(double share) { return share; }
double as_on_the_page(double share) { return 0.5 + share; }

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
      map_slips(p, {below_0_added, as_it_is, as_on_the_page}, wrong_beginnings),
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
    {"at the north pole v is 1, also where rounding made y more than 1", {{1e-12, 1 + 0x1p-52, 0}}},
};

/// By the numbers of column and row, and what they are before the decimals are left out.
Slips<bool> wrong_by_numbers(double c, double r, double x, double z) {
  const auto is_even = [](double number) { return fmod(number, 2) == 0; };
  return {
      {"these are stripes, not squares: you look at x or at z alone", {is_even(c), is_even(r)}},
      {"ask whether the sum of column and row is even",
       {{"their product is even too often", is_even(c * r)},
        {"two odd numbers make an even sum, too", is_even(c) && is_even(r)},
        {"equal column and row are the diagonal alone", c == r},
        {"% is the remainder, / the quotient", trunc((c + r) / 2) == 0},
        {"C++ reads a + b % 2 as a + (b % 2)", c + fmod(r, 2) == 0},
        {"% 2 of an odd number is 1, or -1 below 0", {fmod(c + r, 2) != 1, fmod(c - r, 2) != 1}}}},
      {"std::floor each of x / size and z / size before you add: these are slanted stripes",
       {is_even(floor(x + z)), is_even(trunc(x + z))}},
  };
}

Slips<bool> wrong_squares(double x, double z, double size) {
  const auto is_even = [](double number) { return fmod(number, 2) == 0; };
  const auto even = [&](double column, double row) { return is_even(floor(column) + floor(row)); };
  const double c = x / size, r = z / size;  // with their decimals
  Slips<bool> wrong = {
      {"two squares of one color meet at x = 0: std::floor goes down, static_cast<int> toward 0",
       {is_even(trunc(c) + trunc(r)), is_even(floor(c) + trunc(r)), is_even(trunc(c) + floor(r))}},
      {"std::round and std::ceil move the squares: take std::floor",
       {is_even(round(c) + round(r)), is_even(ceil(c) + ceil(r)), !is_even(ceil(c) + floor(r))}},
      {"your squares have another size: divide by size alone",
       {even(x, z), even(x * size, z * size), even(2 * c, 2 * r), even(c / 2, r / 2)}},
      {"leave out the decimals of the quotient: x / size comes first",
       {even(floor(x) / size, floor(z) / size), even(trunc(x) / size, trunc(z) / size)}},
      wrong_by_numbers(floor(c), floor(r), c, r),
      wrong_by_numbers(trunc(c), trunc(r), c, r),
  };
  return {
      wrong,
      {"the two colors are exchanged", !even(c, r)},
      changed(wrong, [](bool first) { return !first; }),
  };
}

bool right_color(double x, double z, double size) {
  return fmod(floor(x / size) + floor(z / size), 2) == 0;
}
constexpr Place<double, double, double> is_first_color_places[] = {
    {"with size 1, (0.3, 0.6) is in the square that begins at (0, 0)", {0.3, 0.6, 1}},
    {"with size 1, (1.3, 0.6) has the other color", {1.3, 0.6, 1}},
    {"with size 1, (0.3, 1.6) has the other color", {0.3, 1.6, 1}},
    {"with size 1, (1.3, 1.6) has the first color", {1.3, 1.6, 1}},
    {"with size 1, (5.2, 0.6) has the other color", {5.2, 0.6, 1}},
    {"with size 1, (2.3, 0.6) has the first color", {2.3, 0.6, 1}},
    {"with size 2, (1.3, 0.2) has the first color", {1.3, 0.2, 2}},
    {"with size 0.5, (0.3, 0.6) has the other color", {0.3, 0.6, 0.5}},
    {"with size 1, (-0.3, 0.6) has the other color: it is left of x = 0", {-0.3, 0.6, 1}},
    {"with size 1, (-1, 0.6) has the other color: a lower edge belongs to it", {-1, 0.6, 1}},
    {"with size 1, (0.3, -0.6) has the other color", {0.3, -0.6, 1}},
    {"with size 1, (-0.3, -0.6) has the first color", {-0.3, -0.6, 1}},
    {"with size 1, (-1.4, 0.2) has the first color", {-1.4, 0.2, 1}},
    {"with size 0.75, (-3.5, 2.6)", {-3.5, 2.6, 0.75}},
    {"with size 3, (-10, -2)", {-10, -2, 3}},
    {"on the edge x = 0 the square that begins there counts", {0, 0.5, 1}},
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

/// The pattern is the same one turn further.
Place2 within_a_turn(const Place2& uv) { return {fraction(uv.u), uv.v}; }
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

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      "02",
      {exercise(chapter_02::uv_of, picture<Lesson>(), {right_place, wrong_places, uv_of_places}),
       exercise(is_first_color, picture<Lesson>(),
                {right_color, wrong_squares, is_first_color_places}),
       exercise(as_bricks, picture<Lesson>({}, 22),
                {right_bricks, wrong_bricks, as_bricks_places, within_a_turn})},
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
  return chapter;
}

}  // namespace texmap::check
