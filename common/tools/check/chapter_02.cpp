// The exercises of chapter 02. The lesson is the chapter's own. It uses RtiowMapping and
// Checkerboard by name; here those names, in the lesson's namespace, mean structs that call the
// student's function.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises.hpp"
#include "map_mistakes.hpp"
#include "texture/checkerboard.hpp"
#include "texture/mapped.hpp"
#include "texture/uv.hpp"

namespace texmap::check {

static Hook<Uv<double>(Vec3<double>)> uv_of;
static Hook<bool(Uv<double>, int)> is_first_color;
static Hook<Uv<double>(Uv<double>)> twice_around;

}  // namespace texmap::check

namespace texmap::chapter_02 {

struct RtiowMapping {
  Uv<double> operator()(const Vec3<double>& p) const {
    const Uv<double> uv = check::uv_of ? check::uv_of.yours(p) : uv_rtiow(p);
    return check::twice_around ? check::twice_around.yours(uv) : uv;
  }
};

struct Checkerboard {
  Rgb even, odd;
  double squares = 10;

  Color<double> operator()(const Uv<double>& uv) const {
    if (!check::is_first_color) return texmap::Checkerboard{even, odd, squares}(uv);
    return check::is_first_color.yours(uv, static_cast<int>(squares)) ? even : odd;
  }
};

}  // namespace texmap::chapter_02

#include "02_checkerboard_uv/lesson.hpp"

namespace texmap::check {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double turn = 2 * pi;
using Vector = Vec3<double>;
using Place2 = Uv<double>;

Image picture() { return drawn<chapter_02::Lesson>(); }

double acos_of_v(const Vector& p) { return std::acos(-p.y) / pi; }

Exercise where_on_the_map() {
  const double r = std::sqrt(0.5);
  Law<Uv<double>(Vector)> law{
      .right = uv_rtiow<double>,
      .places = {{"on +x, u is 1/2 and v is 1/2", {Vector{1, 0, 0}}},
                 {"on +z, u is 1/4", {Vector{0, 0, 1}}},
                 {"on -z, u is 3/4", {Vector{0, 0, -1}}},
                 {"halfway between +x and +z, u is 3/8", {Vector{r, 0, r}}},
                 {"45 degrees north of +x, v is 3/4", {Vector{r, r, 0}}},
                 {"45 degrees south of +x, v is 1/4", {Vector{r, -r, 0}}},
                 {"in the direction (-2, 1, 2) / 3", {Vector{-2. / 3, 1. / 3, 2. / 3}}},
                 {"in the direction (2, -1, -2) / 3", {Vector{2. / 3, -1. / 3, -2. / 3}}},
                 {"at the north pole v is 1, also where rounding made y a little more than 1",
                  {Vector{1e-12, 1 + 0x1p-52, 0}}}},
      .mistakes = {},
      .tolerance = 1e-6};
  const auto wrong = [&](const char* word, std::function<Uv<double>(Vector)> function) {
    law.mistakes.push_back({word, std::move(function)});
  };
  const auto right = law.right;
  wrong(
      "acos gets a number beyond 1 at the pole and gives NaN: limit y to -1 and 1 first, or use "
      "atan2",
      [=](Vector p) {
        return Place2{right(p).u, acos_of_v(p)};
      });
  // Those who make another mistake often use the textbook's acos, too.
  for (const bool textbook : {false, true}) {
    const auto v = [=](const Vector& p) { return textbook ? acos_of_v(p) : right(p).v; };
    wrong("u runs the other way: your map is mirrored", [=](Vector p) {
      return Place2{1 - right(p).u, v(p)};
    });
    wrong("v runs the other way: your map is upside down", [=](Vector p) {
      return Place2{right(p).u, 1 - v(p)};
    });
    wrong("u and v both run the other way: your map is turned by half a turn", [=](Vector p) {
      return Place2{1 - right(p).u, 1 - v(p)};
    });
  }
  add_map_mistakes(law, Vector{1, 1, 1});
  return exercise("02.1", "Uv uv_of(Vec3 p)", std::move(law), uv_of, picture);
}

using IsFirst = bool(Place2, int);

int column_of(const Place2& uv, int squares) { return static_cast<int>(uv.u * squares); }
int row_of(const Place2& uv, int squares) { return static_cast<int>(uv.v * squares); }
bool is_even(int n) { return n % 2 == 0; }

/// A wrong question about the numbers of column and row, with its word.
struct WrongQuestion {
  const char* word;
  bool (*function)(int column, int row, int squares);
};

constexpr const char* product = "column and row must be added; their product is even too often";

constexpr WrongQuestion wrong_questions[] = {
    {"you look at u alone: these are stripes, not squares",
     [](int c, int, int) { return is_even(c); }},
    {"you look at v alone: these are rings, not squares",
     [](int, int r, int) { return is_even(r); }},
    {product, [](int c, int r, int) { return is_even(c * r); }},
    {product, [](int c, int r, int) { return is_even(c) || is_even(r); }},
    {"two odd numbers make an even sum, too: column and row need not both be even",
     [](int c, int r, int) { return is_even(c) && is_even(r); }},
    {"equal column and row are the diagonal alone: compare whether their sum is even",
     [](int c, int r, int) { return c == r; }},
    {"there are two colors: column + row modulo 2, not modulo squares",
     [](int c, int r, int n) { return (c + r) % n == 0; }},
    {"% is the remainder, / the quotient: a number is even if number % 2 is 0",
     [](int c, int r, int) { return (c + r) / 2 == 0; }},
    {"C++ reads a + b % 2 as a + (b % 2): write (a + b) % 2",
     [](int c, int r, int) { return c + r % 2 == 0; }},
    {"a difference of two numbers can be -1: ask for % 2 == 0, or add them",
     [](int c, int r, int) { return (c - r) % 2 != 1; }},
};

/// Wrong numbers of column and row, with their word.
struct WrongNumbers {
  const char* word;
  int (*column)(const Place2& uv, int squares);
  int (*row)(const Place2& uv, int squares);
};

constexpr WrongNumbers wrong_numbers[] = {
    {"`squares` says how many there are: not always 10",
     [](const Place2& uv, int) { return column_of(uv, 10); },
     [](const Place2& uv, int) { return row_of(uv, 10); }},
    {"multiply by squares, not by squares - 1: the last column would be at u = 1 alone",
     [](const Place2& uv, int n) { return column_of(uv, n - 1); },
     [](const Place2& uv, int n) { return row_of(uv, n - 1); }},
    {"cut the numbers of column and row off, do not round them",
     [](const Place2& uv, int n) { return static_cast<int>(std::lround(uv.u * n)); },
     [](const Place2& uv, int n) { return static_cast<int>(std::lround(uv.v * n)); }},
    {"cut off the decimals of column and row each, then add: now these are slanted stripes",
     [](const Place2& uv, int n) { return static_cast<int>((uv.u + uv.v) * n); },
     [](const Place2&, int) { return 0; }},
    {"the decimals are cut off too early: it is static_cast<int>(uv.u * squares), the product",
     [](const Place2& uv, int n) { return static_cast<int>(uv.u) * n; },
     [](const Place2& uv, int n) { return static_cast<int>(uv.v) * n; }},
};

void add_mistakes_with_the_square(Law<IsFirst>& law) {
  // Those who make another mistake often forget v = 1, or exchange the colors, too.
  for (const bool exchanged : {false, true}) {
    for (const bool limited : {true, false}) {
      const auto wrong = [&](const char* word, auto column, auto row, auto question) {
        law.mistakes.push_back({word, [=](const Place2& uv, int n) {
                                  const int r = limited ? std::min(row(uv, n), n - 1) : row(uv, n);
                                  return question(column(uv, n), r, n) != exchanged;
                                }});
      };
      const auto even_sum = [](int c, int r, int) { return is_even(c + r); };
      if (exchanged) {
        wrong("the two colors are exchanged", column_of, row_of, even_sum);
      } else if (!limited) {
        wrong("at v = 1 you begin a new row: put it into the last one", column_of, row_of,
              even_sum);
      }
      for (const WrongQuestion& one : wrong_questions) {
        wrong(one.word, column_of, row_of, one.function);
      }
      for (const WrongNumbers& one : wrong_numbers) {
        wrong(one.word, one.column, one.row, even_sum);
      }
    }
  }
  law.mistakes.push_back(
      {"`squares` says how many there are: not always 10", [](const Place2& uv, int) {
         return is_even(column_of(uv, 10) + std::min(row_of(uv, 10), 9));
       }});
  law.mistakes.push_back({"std::max puts every row into the last one: std::min(row, squares - 1)",
                          [](const Place2& uv, int n) {
                            return is_even(column_of(uv, n) + std::max(row_of(uv, n), n - 1));
                          }});
}

Exercise which_square() {
  Law<IsFirst> law{
      .right =
          [](Place2 uv, int squares) {
            return texmap::Checkerboard{white, blue, double(squares)}(uv).r > 0.5;
          },
      .places = {{"the square at (0, 0) is the lower left one", {Place2{0.01, 0.01}, 10}},
                 {"of 10 x 10 squares, the one at (0.15, 0.05) has the other color",
                  {Place2{0.15, 0.05}, 10}},
                 {"of 10 x 10 squares, the one at (0.05, 0.15) has the other color",
                  {Place2{0.05, 0.15}, 10}},
                 {"of 10 x 10 squares, the one at (0.15, 0.15) has the lower left color",
                  {Place2{0.15, 0.15}, 10}},
                 {"of 10 x 10 squares, the one at (0.12, 0.07) has the other color",
                  {Place2{0.12, 0.07}, 10}},
                 {"of 10 x 10 squares, the one at (0.55, 0.05) has the other color",
                  {Place2{0.55, 0.05}, 10}},
                 {"of 10 x 10 squares, the one at (0.37, 0.72) has the lower left color",
                  {Place2{0.37, 0.72}, 10}},
                 {"of 4 x 4 squares, the one at (0.55, 0.3) has the other color",
                  {Place2{0.55, 0.3}, 4}},
                 {"of 9 x 9 squares, the one at (0.99, 0.99) has the lower left color",
                  {Place2{0.99, 0.99}, 9}},
                 {"of 9 x 9 squares, the one at (0.95, 0.3) has the lower left color",
                  {Place2{0.95, 0.3}, 9}},
                 {"at the north pole v is 1: this is the last row; the square at (0.05, 1) has the "
                  "other color",
                  {Place2{0.05, 1}, 10}},
                 {"v = 1 is in the last row: the square at (0.15, 1) has the lower left color",
                  {Place2{0.15, 1}, 10}}},
      .mistakes = {}};
  add_mistakes_with_the_square(law);
  return exercise("02.2", "bool is_first_color(Uv uv, int squares)", std::move(law), is_first_color,
                  picture);
}

Exercise square_squares() {
  using Function = Place2(Place2);
  const auto twice = [](double u, double v) {
    return [u, v](Place2 uv) { return Place2{u * uv.u, v * uv.v}; };
  };
  Law<Function> law{
      .right = twice(2, 1),
      .places = {{"where the map begins, u stays 0, and v stays as it is", {Place2{0, 0.5}}},
                 {"after half a turn, u = 1/2, the pattern has gone around once: u becomes 1",
                  {Place2{0.5, 0.5}}},
                 {"after three quarters of a turn u becomes 1.5: it may be more than 1",
                  {Place2{0.75, 0.25}}},
                 {"u = 1/4 becomes 1/2, and v stays as it is", {Place2{0.25, 0.75}}}},
      .mistakes = {},
      .tolerance = 1e-12};
  const auto wrong = [&](const char* word, std::function<Function> function) {
    law.mistakes.push_back({word, std::move(function)});
  };
  wrong(
      "v must stay as it is: the squares are smaller now, and still twice as wide as they are high",
      twice(2, 2));
  wrong("v is doubled and u is not: now the squares are four times as wide as they are high",
        twice(1, 2));
  wrong("the pattern goes around once in two turns: multiply u, do not divide it", twice(0.5, 1));
  wrong("the pattern goes around once in two turns: multiply u, and leave v", twice(0.5, 0.5));
  wrong("now the squares are eight times as wide as they are high: multiply u, and leave v",
        twice(0.5, 2));
  wrong("the squares are square, but larger and not twice around: multiply u, and leave v",
        twice(1, 0.5));
  wrong("v must stay as it is: now the squares are twice as high as they are wide", twice(2, 0.5));
  wrong("u is 0 everywhere, because 1 / 2 is 0 in C++; and it has to be multiplied by 2",
        twice(0, 1));
  wrong("v must stay as it is: you lose it", twice(2, 0));
  wrong("v must stay as it is: you lose it", twice(1, 0));
  wrong("u and v stay as they were: the pattern goes around twice with 2 * u", twice(1, 1));
  wrong("that is more than twice around: the checkerboard itself multiplies by its 10 squares",
        twice(10, 1));
  for (const double v : {1.0, 10.0, 20.0}) {
    wrong("that is 20 times around: the checkerboard itself multiplies by its 10 squares",
          twice(20, v));
  }
  wrong("that is four times around: u is multiplied by 2", twice(4, 1));
  wrong("u is a part of a turn, no angle: multiply it by 2 alone", twice(turn, 1));
  for (const double v : {1.0, 2.0}) {
    const char* const beyond = "u may be more than 1: let it, the checkerboard goes on there";
    wrong(beyond, [=](Place2 uv) {
      return Place2{std::fmod(2 * uv.u, 1.0), v == 1 ? uv.v : std::fmod(v * uv.v, 1.0)};
    });
    wrong(beyond, [=](Place2 uv) {
      return Place2{uv.u > 0.5 ? 2 * uv.u - 1 : 2 * uv.u, v * uv.v};
    });
    wrong(beyond, [=](Place2 uv) { return Place2{std::min(2 * uv.u, 1.0), v * uv.v}; });
  }
  for (const double shift : {0.5, 1.0, 2.0}) {
    wrong("adding to u only turns the pattern: multiply u", [=](Place2 uv) {
      return Place2{uv.u + shift, uv.v};
    });
  }
  wrong("the second number of the result comes from v, and u is not in it", [](Place2 uv) {
    return Place2{2 * uv.u, 2 * uv.u};
  });
  wrong("the second number of the result comes from v, and u is not in it", [](Place2 uv) {
    return Place2{2 * uv.u, uv.u};
  });
  wrong("u and v are exchanged: u comes first, and it is multiplied by 2", [](Place2 uv) {
    return Place2{uv.v, 2 * uv.u};
  });
  wrong("u and v are exchanged: u comes first, and it is multiplied by 2", [](Place2 uv) {
    return Place2{2 * uv.v, uv.u};
  });
  wrong("twice is 2 * u, not u * u", [](Place2 uv) { return Place2{uv.u * uv.u, uv.v}; });
  wrong("the decimals of u are needed: no static_cast<int> here", [](Place2 uv) {
    return Place2{std::floor(2 * uv.u), uv.v};
  });
  return exercise("02.3", "Uv twice_around(Uv uv)", std::move(law), twice_around, picture);
}

/// The northern latitude, in degrees, where a square of the checkerboard is as wide as it is high.
double latitude_of_squares() {
  const auto uv_at = [](double east, double north) {  // in radians, from +x
    return uv_rtiow(Vector{std::cos(north) * std::cos(east), std::sin(north),
                           -std::cos(north) * std::sin(east)});
  };
  double low = 0;
  double high = pi / 2;
  for (int i = 0; i < 50; ++i) {
    const double north = (low + high) / 2;
    constexpr double step = 1e-4;  // of the same length on the sphere in both directions
    const double u = uv_at(step / std::cos(north), north).u - uv_at(0, north).u;
    const double v = uv_at(0, north + step).v - uv_at(0, north).v;
    (u < v ? low : high) = north;
  }
  return low * 180 / pi;
}

/// The longest piece of one color on the equator, in degrees, with so many squares.
double longest_piece(double squares) {
  chapter_02::Checkered checkered = chapter_02::Lesson{}.checkered;
  checkered.texture.squares = squares;
  constexpr int parts = 36000;
  const auto is_blue = [&](int i) {
    const double angle = 2 * pi * (i + 0.5) / parts;
    const Place2 uv = checkered.mapping(Vector{std::cos(angle), 0, std::sin(angle)});
    return checkered.texture(uv).r == blue.r;
  };
  int longest = 0;
  int length = 0;
  for (int i = 1; i < 2 * parts; ++i) {  // twice around: a piece may lie across the beginning
    length = is_blue(i) == is_blue(i - 1) ? length + 1 : 1;
    longest = std::max(longest, length);
  }
  return 360.0 * longest / parts;
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      .exercises = {where_on_the_map(), which_square(), square_squares()},
      .questions = {{"02.a",
                     "On the equator a square of the checkerboard is twice as wide as it is high. "
                     "At which latitude, in degrees, is it as wide as it is high?",
                     latitude_of_squares, "degrees"},
                    {"02.b",
                     "With 9 squares in place of 10: how long is the longest piece of one color "
                     "on the equator, in degrees?",
                     [] { return longest_piece(9); }, "degrees"}},
  };
  return chapter;
}

}  // namespace texmap::check
