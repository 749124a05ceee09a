// The exercises of chapter 02. The lesson is the chapter's own. It uses RtiowMapping and
// Checkerboard by name; here those names, in the lesson's namespace, mean structs that call the
// student's function.
#include "exercises.hpp"
#include "map_mistakes.hpp"
#include "texture/checkerboard.hpp"
#include "texture/mapped.hpp"

namespace texmap::chapter_02 {

static std::function<Uv<double>(Vec3d)> uv_of;
static std::function<bool(Uv<double>, int)> is_first_color;
static std::function<Uv<double>(Uv<double>)> twice_around;

struct RtiowMapping {
  Uv<double> operator()(const Vec3d& p) const {
    const Uv<double> uv = uv_of ? uv_of(p) : uv_rtiow(p);
    return twice_around ? twice_around(uv) : uv;
  }
};

struct Checkerboard {
  Rgb even, odd;
  double squares = 10;

  Rgb operator()(const Uv<double>& uv) const {
    if (!is_first_color) return texmap::Checkerboard{even, odd, squares}(uv);
    return is_first_color(uv, static_cast<int>(squares)) ? even : odd;
  }
};

}  // namespace texmap::chapter_02

#include "02_checkerboard_uv/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_02;

Slips<Place2> wrong_places(Vec3d p) {
  const auto [u, v] = uv_rtiow(p);
  const double by_acos = acos(-p.y) / pi;  // the textbook's v
  return {
      {"acos gets a number beyond 1 at the pole and gives NaN: limit y to -1 and 1 first, or use "
       "atan2",
       {u, by_acos}},
      {"u runs the other way: your map is mirrored", {{1 - u, v}, {1 - u, by_acos}}},
      {"v runs the other way: your map is upside down", {{u, 1 - v}, {u, 1 - by_acos}}},
      {"u and v both run the other way: your map is turned by half a turn",
       {{1 - u, 1 - v}, {1 - u, 1 - by_acos}}},
      map_slips(p),
  };
}

constexpr Place<Vec3d> uv_of_places[] = {
    {"on +x, u is 1/2 and v is 1/2", {{1, 0, 0}}},
    {"on +z, u is 1/4", {{0, 0, 1}}},
    {"on -z, u is 3/4", {{0, 0, -1}}},
    {"halfway between +x and +z, u is 3/8", {{half_root, 0, half_root}}},
    {"45 degrees north of +x, v is 3/4", {{half_root, half_root, 0}}},
    {"45 degrees south of +x, v is 1/4", {{half_root, -half_root, 0}}},
    {"in the direction (-2, 1, 2) / 3", {{-2. / 3, 1. / 3, 2. / 3}}},
    {"in the direction (2, -1, -2) / 3", {{2. / 3, -1. / 3, -2. / 3}}},
    {"at the north pole v is 1, also where rounding made y a little more than 1",
     {{1e-12, 1 + 0x1p-52, 0}}},
};

Slips<bool> wrong_squares(Place2 uv, int n) {
  const auto is_even = [](int number) { return number % 2 == 0; };
  const auto [u, v] = uv;
  const int c = cut_off(u * n);
  const int any_r = cut_off(v * n);
  Slips<bool> wrong;
  // Those who make another mistake often forget v = 1, or exchange the colors, too.
  for (const int most : {n - 1, n}) {
    const auto even = [&](double x, double y) {
      return is_even(cut_off(x) + min(cut_off(y), most));
    };
    const int r = min(any_r, most);
    wrong += {
        {"you look at u alone: these are stripes, not squares", is_even(c)},
        {"you look at v alone: these are rings, not squares", is_even(r)},
        {"column and row must be added; their product is even too often", is_even(c * r)},
        {"two odd numbers make an even sum, too: column and row need not both be even",
         is_even(c) && is_even(r)},
        {"equal column and row are the diagonal alone: compare whether their sum is even", c == r},
        {"there are two colors: column + row modulo 2, not modulo squares", (c + r) % n == 0},
        {"% is the remainder, / the quotient: a number is even if number % 2 is 0",
         (c + r) / 2 == 0},
        {"C++ reads a + b % 2 as a + (b % 2): write (a + b) % 2", c + r % 2 == 0},
        {"a difference of two numbers can be -1: ask for % 2 == 0, or add them", (c - r) % 2 != 1},
        {"`squares` says how many there are: not always 10",
         {even(u * 10, v * 10), is_even(cut_off(u * 10) + min(cut_off(v * 10), 9))}},
        {"multiply by squares, not by squares - 1: the last column would be at u = 1 alone",
         even(u * (n - 1), v * (n - 1))},
        {"cut the numbers of column and row off, do not round them",
         even(round(u * n), round(v * n))},
        {"cut off the decimals of column and row each, then add: now these are slanted stripes",
         is_even(cut_off((u + v) * n))},
        {"the decimals are cut off too early: it is static_cast<int>(uv.u * squares), the product",
         even(floor(u) * n, floor(v) * n)},
        {"std::max puts every row into the last one: std::min(row, squares - 1)",
         is_even(c + max(r, n - 1))},
    };
  }
  return {
      wrong,
      {"at v = 1 you begin a new row: put it into the last one", is_even(c + any_r)},
      {"the two colors are exchanged", {!is_even(c + min(any_r, n - 1)), !is_even(c + any_r)}},
      changed(wrong, [](bool first) { return !first; }),
  };
}

bool right_color(Place2 uv, int n) { return texmap::Checkerboard{white, blue, 1. * n}(uv).r > 0.5; }
constexpr Place<Place2, int> is_first_color_places[] = {
    {"the square at (0, 0) is the lower left one", {{0.01, 0.01}, 10}},
    {"of 10 x 10 squares, the one at (0.15, 0.05) has the other color", {{0.15, 0.05}, 10}},
    {"of 10 x 10 squares, the one at (0.05, 0.15) has the other color", {{0.05, 0.15}, 10}},
    {"of 10 x 10 squares, the one at (0.15, 0.15) has the lower left color", {{0.15, 0.15}, 10}},
    {"of 10 x 10 squares, the one at (0.12, 0.07) has the other color", {{0.12, 0.07}, 10}},
    {"of 10 x 10 squares, the one at (0.55, 0.05) has the other color", {{0.55, 0.05}, 10}},
    {"of 10 x 10 squares, the one at (0.37, 0.72) has the lower left color", {{0.37, 0.72}, 10}},
    {"of 4 x 4 squares, the one at (0.55, 0.3) has the other color", {{0.55, 0.3}, 4}},
    {"of 9 x 9 squares, the one at (0.99, 0.99) has the lower left color", {{0.99, 0.99}, 9}},
    {"of 9 x 9 squares, the one at (0.95, 0.3) has the lower left color", {{0.95, 0.3}, 9}},
    {"at the north pole v is 1: this is the last row; the square at (0.05, 1) has the other color",
     {{0.05, 1}, 10}},
    {"v = 1 is in the last row: the square at (0.15, 1) has the lower left color", {{0.15, 1}, 10}},
    {"u = 0 is in the first column: (0, 0.05) has the lower left color", {{0, 0.05}, 10}},
};

Slips<Place2> wrong_twice_around(Place2 uv) {
  const auto [u, v] = uv;
  const double most = min(2 * u, 1.0);
  return {
      {"v must stay as it is: the squares are smaller now, and still twice as wide as they are "
       "high",
       {{2 * u, 2 * v}, {2 * u, fmod(2 * v, 1.0)}}},
      {"v is doubled and u is not: now the squares are four times as wide as they are high",
       {u, 2 * v}},
      {"the pattern goes around once in two turns: multiply u, do not divide it", {u / 2, v}},
      {"the pattern goes around once in two turns: multiply u, and leave v", {u / 2, v / 2}},
      {"now the squares are eight times as wide as they are high: multiply u, and leave v",
       {u / 2, 2 * v}},
      {"the squares are square, but larger and not twice around: multiply u, and leave v",
       {u, v / 2}},
      {"v must stay as it is: now the squares are twice as high as they are wide", {2 * u, v / 2}},
      {"u is a whole number everywhere: 1 / 2 is 0 in C++, and static_cast<int> drops the "
       "decimals; "
       "multiply u by 2",
       {0, v}},
      {"v must stay as it is: you lose it", {{2 * u, 0}, {u, 0}}},
      {"the pattern looks as it was: it goes around twice with 2 * u", uv},
      {"that is more than twice around: the checkerboard itself multiplies by its 10 squares",
       {10 * u, v}},
      {"that is 20 times around: the checkerboard itself multiplies by its 10 squares",
       {{20 * u, v}, {20 * u, 10 * v}, {20 * u, 20 * v}}},
      {"that is four times around: u is multiplied by 2", {4 * u, v}},
      {"u is a part of a turn, no angle: multiply it by 2 alone", {2 * pi * u, v}},
      {"u may be more than 1: let it, the checkerboard goes on there", {{most, v}, {most, 2 * v}}},
      {"adding to u only turns the pattern: multiply u", {{u + 0.5, v}, {u + 0.25, v}}},
      {"the second number of the result comes from v, and u is not in it",
       {{2 * u, 2 * u}, {2 * u, u}}},
      {"u and v are exchanged: u comes first, and it is multiplied by 2", {{v, 2 * u}, {2 * v, u}}},
      {"twice is 2 * u, not u * u", {u * u, v}},
  };
}

Place2 right_twice_around(Place2 uv) { return {2 * uv.u, uv.v}; }
/// The pattern is the same one turn further.
Place2 within_a_turn(const Place2& uv) { return {fraction(uv.u), uv.v}; }
constexpr Place<Place2> twice_around_places[] = {
    {"where the map begins, u stays 0, and v stays as it is", {{0, 0.5}}},
    {"after half a turn, u = 1/2, the pattern has gone around once: u becomes 1", {{0.5, 0.5}}},
    {"after three quarters of a turn u becomes 1.5: it may be more than 1", {{0.75, 0.25}}},
    {"u = 1/4 becomes 1/2, and v stays as it is", {{0.25, 0.75}}},
    {"u = 1/8 becomes 1/4", {{0.125, 0.5}}},
    {"u = 1/10 becomes 1/5", {{0.1, 0.5}}},
};

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      "02",
      {exercise(chapter_02::uv_of, picture<Lesson>(),
                {uv_rtiow<double>, wrong_places, uv_of_places}),
       exercise(is_first_color, picture<Lesson>(),
                {right_color, wrong_squares, is_first_color_places}),
       exercise(twice_around, picture<Lesson>(),
                {right_twice_around, wrong_twice_around, twice_around_places, within_a_turn})},
      {{"On the equator a square of the checkerboard is twice as wide as it is high. At which "
        "latitude, in degrees, is it as wide as it is high?",
        [] { return acos(0.5) / radian; }, "degrees"},
       {"With 9 squares in place of 10: how long is the longest piece of one color on the equator, "
        "in degrees?",
        [] { return 2 * 360. / 9; }, "degrees"}},
  };
  return chapter;
}

}  // namespace texmap::check
