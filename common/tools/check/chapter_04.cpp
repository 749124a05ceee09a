// The exercises of chapter 04. The lesson is the chapter's own. Its ConventionMapping is this one
// here, which calls the student's functions.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises.hpp"
#include "map_mistakes.hpp"
#include "published/uv.hpp"
#include "texture/conventions.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::check {

static Hook<Uv<double>(Vec3<double>)> uv_of;
static Hook<double(double)> lecture_u;
static Hook<bool(Uv<double>, Uv<double>, Uv<double>)> is_mirrored;

/// Whether the student's function calls this convention mirrored. It gets the (u, v) of one point
/// that the picture shows, and of two neighbors.
static bool mirrors(Convention convention) {
  constexpr double step = 0.01;
  const auto place = [=](double u, double v) {
    const Uv<double> uv = texmap::uv_of(convention, direction_rtiow(Uv<double>{u, v}));
    return Uv<double>{uv.u, v_axis_of(convention) == VAxis::up ? uv.v : 1 - uv.v};
  };
  return is_mirrored.yours(place(0.3, 0.6), place(0.3 + step, 0.6), place(0.3, 0.6 + step));
}

}  // namespace texmap::check

namespace texmap::chapter_04 {

struct ConventionMapping {
  Convention convention = Convention::rtiow;

  Uv<double> operator()(const Vec3<double>& p) const {
    if (check::uv_of) return check::uv_of.yours(p);
    if (check::lecture_u) {
      const Uv<double> uv = uv_rtiow(p);
      return {check::lecture_u.yours(uv.u), uv.v};
    }
    const Uv<double> uv = texmap::uv_of(convention, p);
    return check::is_mirrored && check::mirrors(convention) ? Uv<double>{1 - uv.u, uv.v} : uv;
  }
};

// The lesson's own one draws a sheet, in all numbers. The exercises draw the stage alone.
struct Lesson;
static void show_conventions(const Lesson&, Session&) {}

}  // namespace texmap::chapter_04

#include "04_uv_conventions/lesson.hpp"

namespace texmap::check {
namespace {

constexpr double turn = 2 * std::numbers::pi;
using Vector = Vec3<double>;
using Place2 = Uv<double>;

/// The globe from nearby, after these words of the chapter's command line.
Image globe(const std::vector<std::string>& words) {
  auto lesson = prepared<chapter_04::Lesson>(words);
  lesson.stage.camera.fov_y_degrees = 18;
  return picture_of(lesson);
}

Exercise another_convention() {
  const double r = std::sqrt(0.5);
  Law<Place2(Vector)> law{
      .right = [](const Vector& p) { return texmap::uv_of(Convention::daily, p); },
      .places = {{"on +x, u is 1/2 and v is 1/2", {Vector{1, 0, 0}}},
                 {"on +z, u is 3/4", {Vector{0, 0, 1}}},
                 {"on -z, u is 1/4", {Vector{0, 0, -1}}},
                 {"45 degrees north of +x, v is 1/4", {Vector{r, r, 0}}},
                 {"45 degrees south of +x, v is 3/4", {Vector{r, -r, 0}}},
                 {"halfway between +x and +z, u is 5/8", {Vector{r, 0, r}}},
                 {"in the direction (-2, 1, 2) / 3", {Vector{-2. / 3, 1. / 3, 2. / 3}}},
                 {"at the north pole v is 0, also where rounding made y a little more than 1",
                  {Vector{1e-12, 1 + 0x1p-52, 0}}}},
      .mistakes = {},
      .tolerance = 1e-6};
  // Those who make another mistake often forget to limit y, too.
  for (const bool limited : {true, false}) {
    const auto wrong = [&](const char* word, double east, double up) {
      law.mistakes.push_back({word, [=](const Vector& p) {
                                const double y = limited ? std::clamp(p.y, -1.0, 1.0) : p.y;
                                return Place2{0.5 - east * std::atan2(p.z, p.x) / turn,
                                              0.5 + up * std::asin(y) / (turn / 2)};
                              }});
    };
    wrong("u runs east: here it has to run west; the sign of z says which way", 1, -1);
    wrong("v runs up: here it has to run down from the north pole", -1, 1);
    wrong("u runs east and v runs up: this is the convention of chapter 02", 1, 1);
    if (!limited) {
      wrong("acos and asin give NaN for a y beyond 1, at the pole: limit y to -1 and 1 first", -1,
            -1);
    }
  }
  add_map_mistakes(law, Vector{1, -1, -1});
  return exercise("04.1", "Uv uv_of(Vec3 p)", std::move(law), uv_of, [] {
    return globe({"--convention", "daily"});
  });
}

double part(double u) { return u - std::floor(u); }

void add_mistakes_with_the_quarter(Law<double(double)>& law) {
  const auto wrong = [&](const char* word, double (*function)(double)) {
    law.mistakes.push_back({word, function});
  };
  wrong("below 0 a whole turn is missing: add 1 there (std::fmod does not)",
        [](double u) { return u - 0.25; });
  wrong("from 1 on a whole turn is too much: subtract 1 there", [](double u) { return u + 0.75; });
  wrong("this turns the other way: +z has to get u = 0, not 1/2",
        [](double u) { return part(u + 0.25); });
  wrong("this turns the other way, and from 1 on a whole turn is too much",
        [](double u) { return u + 0.25; });
  wrong("this turns the other way, and below 0 a whole turn is missing",
        [](double u) { return u - 0.75; });
  wrong("at u = 1/4 you give 1, and that is 0: < 0.25 there, not <=",
        [](double u) { return u <= 0.25 ? u + 0.75 : u - 0.25; });
  wrong("the two cases are exchanged: u - 1/4 is negative where u is less than 1/4",
        [](double u) { return u < 0.25 ? u - 0.25 : u + 0.75; });
  const char* const unchanged =
      "u stays as it was: subtract 0.25 (1 / 4 is 0 in C++, and so is 3 / 4)";
  wrong(unchanged, [](double u) { return u; });
  wrong("three quarters stay as they were: there it is u - 0.25 (in C++ 1 / 4 is 0)",
        [](double u) { return u < 0.25 ? u + 0.75 : u; });
  wrong("the first quarter stays as it was: there it is u + 0.75 (in C++ 3 / 4 is 0)",
        [](double u) { return u < 0.25 ? u : u - 0.25; });
  const char* const reflected =
      "you reflect where u - 1/4 is negative: add a whole turn there, no absolute value";
  wrong(reflected, [](double u) { return std::abs(u - 0.25); });
  wrong("you cut off at 0: the first quarter comes after the others, at u + 3/4",
        [](double u) { return std::max(u - 0.25, 0.0); });
  wrong("you cut off at 1: the other quarters come before the first one, at u - 1/4",
        [](double u) { return std::min(u + 0.75, 1.0); });
  const char* const whole = "where u - 1/4 is negative, add a whole turn to it: u - 1/4 + 1";
  wrong(whole, [](double u) { return u < 0.25 ? u + 1 : u - 0.25; });
  wrong(whole, [](double u) { return u < 0.25 ? u + 0.25 : u - 0.25; });
  wrong(whole, [](double u) { return u < 0.25 ? u - 0.25 + 0.5 : u - 0.25; });
  wrong(whole, [](double u) { return u < 0.25 ? 0.75 : u - 0.25; });
  wrong(whole, [](double u) { return u < 0.25 ? 1.0 : u - 0.25; });
  wrong(whole, [](double u) { return u < 0.25 ? 0.75 - u : u - 0.25; });
  wrong(whole, [](double u) { return u < 0.25 ? 1 - u : u - 0.25; });
  wrong(whole, [](double u) { return u < 0.25 ? 1 - (u - 0.25) : u - 0.25; });
  wrong("u is in turns, not in radians: a whole turn is 1",
        [](double u) { return u < 0.25 ? u - 0.25 + turn : u - 0.25; });
  for (const double quarter : {turn / 4, 90.0}) {
    for (const double whole_turn : {0.0, 1.0, 4 * quarter}) {
      law.mistakes.push_back({"u is in turns: a quarter of a turn is 0.25", [=](double u) {
                                return u < quarter ? u - quarter + whole_turn : u - quarter;
                              }});
    }
  }
  const char* const half =
      "+z is at u = 1/4, so the two differ by a quarter of a turn, not by half";
  wrong(half, [](double u) { return part(u + 0.5); });
  wrong(half, [](double u) { return u - 0.5; });
  wrong(half, [](double u) { return u + 0.5; });
  wrong("u moves by a quarter of a turn: subtract it, do not multiply or divide",
        [](double u) { return u * 0.25; });
  wrong("u moves by a quarter of a turn: subtract it, do not multiply or divide",
        [](double u) { return u * 4; });
  const char* const runs = "u runs the other way: both conventions run east";
  wrong(runs, [](double u) { return part(0.25 - u); });
  wrong(runs, [](double u) { return 0.25 - u; });
  wrong(runs, [](double u) { return 1.25 - u; });
  wrong(runs, [](double u) { return part(0.75 - u); });
  wrong(runs, [](double u) { return 0.75 - u; });
  wrong(runs, [](double u) { return part(1 - u); });
  wrong(runs, [](double u) { return 1 - u; });
}

Exercise from_one_to_another() {
  Law<double(double)> law{.right =
                              [](double u) {
                                return in_convention(Convention::lecture, Place2{u, 0.5}).u;
                              },
                          .places = {{"on +z, u goes from 1/4 to 0", {0.25}},
                                     {"on +x, u goes from 1/2 to 1/4", {0.5}},
                                     {"on -z, u goes from 3/4 to 1/2", {0.75}},
                                     {"on -x, u goes from 0 to 3/4", {0.0}},
                                     {"u = 0.1 becomes 0.85", {0.1}},
                                     {"u = 0.95 becomes 0.7", {0.95}}},
                          .mistakes = {},
                          .tolerance = 1e-9};
  add_mistakes_with_the_quarter(law);
  return exercise("04.2", "double lecture_u(double u)", std::move(law), lecture_u, [] {
    return globe({"--convention", "lecture"});
  });
}

using IsMirrored = bool(Place2, Place2, Place2);

/// The four slopes, or what a student takes for them: of u and v toward the east and the north.
struct Slopes {
  double u_e, v_e, u_n, v_n;
};

Slopes slopes_of(Place2 here, Place2 east, Place2 north) {
  return {east.u - here.u, east.v - here.v, north.u - here.u, north.v - here.v};
}
double determinant(const Slopes& s) { return s.u_e * s.v_n - s.u_n * s.v_e; }
double sum_of_products(const Slopes& s) { return s.u_e * s.v_n + s.u_n * s.v_e; }

/// A number that a student takes for the determinant: the word if its sign means mirrored, and the
/// word if a student has exchanged yes and no, too.
struct Sign {
  const char* word;
  const char* word_if_exchanged;
  double (*number)(const Slopes&);
};

constexpr const char* east_alone =
    "you look at the step to the east alone: the step to the north can be turned around, too";
constexpr const char* north_alone =
    "you look at the step to the north alone: the step to the east can be turned around, too";
constexpr const char* half_turn =
    "two signs that are turned around make half a turn, no mirror: multiply them";
constexpr const char* not_turned =
    "right unless the picture is slanted or turned by a quarter: subtract u_n * v_e, too";
constexpr const char* exchanged_and_not_turned =
    "yes and no are exchanged, and a picture turned by a quarter needs the whole determinant";
constexpr const char* plus = "in the determinant the second product is subtracted";
constexpr const char* half = "this is half of the determinant alone: it is u_e * v_n - u_n * v_e";
constexpr const char* dot_product =
    "this is the dot product: the determinant is u_e * v_n - u_n * v_e";
constexpr const char* other = "the determinant is u_e * v_n - u_n * v_e: yours has other factors";
constexpr const char* either =
    "the step to the east can be turned around, or the one to the north: multiply the two signs";
constexpr const char* crossed =
    "the step to the east moves u if nothing is turned, and the step to the north moves v";
constexpr const char* added = "the signs are multiplied, not added";

constexpr Sign signs[] = {
    {east_alone, east_alone, [](const Slopes& s) { return s.u_e; }},
    {north_alone, north_alone, [](const Slopes& s) { return s.v_n; }},
    {half_turn, "this is mirrored only if one of the two is turned around: multiply the signs",
     [](const Slopes& s) { return std::min(s.u_e, s.v_n); }},
    {"this is mirrored only if one of the two is turned around, and you ask for both", half_turn,
     [](const Slopes& s) { return std::max(s.u_e, s.v_n); }},
    {not_turned, exchanged_and_not_turned, [](const Slopes& s) { return s.u_e * s.v_n; }},
    {plus, plus, sum_of_products},
    {half, half, [](const Slopes& s) { return -s.u_n * s.v_e; }},
    {dot_product, dot_product, [](const Slopes& s) { return s.u_e * s.u_n + s.v_e * s.v_n; }},
    {other, other, [](const Slopes& s) { return s.u_e * s.u_n; }},
    {other, other, [](const Slopes& s) { return s.v_e * s.v_n; }},
    {other, other, [](const Slopes& s) { return s.u_e * s.u_n - s.v_e * s.v_n; }},
    {other, other, [](const Slopes& s) { return s.u_e * s.v_e - s.u_n * s.v_n; }},
    {other, other, [](const Slopes& s) { return s.u_e * s.v_n - s.u_n * s.v_n; }},
    {either, either, [](const Slopes& s) { return s.u_e < 0 && s.v_n > 0 ? -1.0 : 1.0; }},
    {either, either, [](const Slopes& s) { return s.u_e > 0 && s.v_n < 0 ? -1.0 : 1.0; }},
    {crossed, crossed, [](const Slopes& s) { return s.v_e; }},
    {crossed, crossed, [](const Slopes& s) { return s.u_n; }},
    {added, added, [](const Slopes& s) { return s.u_e + s.v_n; }},
};

void add_mistakes_with_the_sign(Law<IsMirrored>& law) {
  const auto wrong = [&](const char* word, auto function) {
    law.mistakes.push_back({word, function});
  };
  wrong("this is never true: multiply the signs of east - here and north - here, or take all four",
        [](Place2, Place2, Place2) { return false; });
  wrong("this is always true: only a negative determinant means mirrored",
        [](Place2, Place2, Place2) { return true; });
  wrong("yes and no are exchanged: a negative determinant means mirrored",
        [](Place2 h, Place2 e, Place2 n) { return determinant(slopes_of(h, e, n)) > 0; });
  for (const Sign& sign : signs) {
    wrong(sign.word,
          [=](Place2 h, Place2 e, Place2 n) { return sign.number(slopes_of(h, e, n)) < 0; });
    wrong(sign.word_if_exchanged,
          [=](Place2 h, Place2 e, Place2 n) { return sign.number(slopes_of(h, e, n)) > 0; });
  }
  wrong("a product of 0 says that the picture is turned by a quarter: take the whole determinant",
        [](Place2 h, Place2 e, Place2 n) { return (e.u - h.u) * (n.v - h.v) <= 0; });
  wrong(exchanged_and_not_turned,
        [](Place2 h, Place2 e, Place2 n) { return (e.u - h.u) * (n.v - h.v) >= 0; });
  // Those who do not subtract `here` from both do so from none or from one.
  const auto places = [&](double (*number)(const Slopes&), double from_east, double from_north) {
    for (const bool exchanged : {false, true}) {
      wrong("these are places, not steps: subtract here from east and from north first",
            [=](Place2 h, Place2 e, Place2 n) {
              const double sign = number({e.u - from_east * h.u, e.v - from_east * h.v,
                                          n.u - from_north * h.u, n.v - from_north * h.v});
              return exchanged ? sign > 0 : sign < 0;
            });
    }
  };
  for (double (*const number)(const Slopes&) : {determinant, sum_of_products}) {
    places(number, 0, 0);
    places(number, 1, 0);
    places(number, 0, 1);
  }
}

Exercise is_it_mirrored() {
  const auto steps = [](double right_e, double up_e, double right_n, double up_n) {
    const Place2 here{0.5, 0.5};
    return std::tuple{here, Place2{here.u + right_e, here.v + up_e},
                      Place2{here.u + right_n, here.v + up_n}};
  };
  Law<IsMirrored> law{
      .right =
          [](Place2 here, Place2 east, Place2 north) {
            const auto flat = [&](Place2 to) { return Vector{to.u - here.u, to.v - here.v, 0}; };
            return cross(flat(east), flat(north)).z < 0;
          },
      .places = {{"east is to the right, north is up: as printed", steps(0.01, 0, 0, 0.01)},
                 {"east is to the left, north is up: mirrored", steps(-0.01, 0, 0, 0.01)},
                 {"east is to the right, north is down: upside down, and mirrored",
                  steps(0.01, 0, 0, -0.01)},
                 {"east is to the left, north is down: turned by half a turn, not mirrored",
                  steps(-0.01, 0, 0, -0.01)},
                 {"east is up, north is to the left: turned by a quarter, not mirrored",
                  steps(0, 0.01, -0.01, 0)},
                 {"east is up, north is to the right: turned by a quarter, and mirrored",
                  steps(0, 0.01, 0.01, 0)},
                 {"both slanted: turned by an eighth, not mirrored",
                  steps(0.01, -0.02, 0.02, 0.01)},
                 {"east is at (+0.01, +0.02), north at (+0.01, +0.01) from here: mirrored",
                  steps(0.01, 0.02, 0.01, 0.01)},
                 {"east is at (-0.02, +0.01), north at (-0.01, +0.01) from here: mirrored",
                  steps(-0.02, 0.01, -0.01, 0.01)},
                 {"east is at (+0.02, +0.01), north at (-0.01, +0.01) from here: not mirrored",
                  steps(0.02, 0.01, -0.01, 0.01)},
                 {"east is at (+0.01, +0.02), north at (-0.01, +0.01) from here: not mirrored",
                  steps(0.01, 0.02, -0.01, 0.01)},
                 {"east is at (+0.01, +0.02), north at (-0.02, -0.01) from here: not mirrored",
                  steps(0.01, 0.02, -0.02, -0.01)}},
      .mistakes = {}};
  add_mistakes_with_the_sign(law);
  return exercise("04.3", "bool is_mirrored(Uv here, Uv east, Uv north)", std::move(law),
                  is_mirrored, [] {
                    return globe({"--convention", "daily", "--texture", "uv_map.png"});
                  });
}

/// By how many columns the lecture's rounding shifts the map where u is this.
double shift_at(double u) {
  const auto lesson = prepared<chapter_04::Lesson>();
  const int width = lesson.texture.load().width;
  return u * width - u * (width - 1);
}

/// The daily exercise's u at the point of the equator that has this u in the lecture's convention.
double daily_u_at_lecture_u(double u) {
  constexpr int parts = 100000;
  Vector best{};
  auto nearest = infinity<double>();
  for (int i = 0; i < parts; ++i) {
    const Vector p = direction_rtiow(Place2{static_cast<double>(i) / parts, 0.5});
    const double off = std::abs(texmap::uv_of(Convention::lecture, p).u - u);
    if (off < nearest) {
      nearest = off;
      best = p;
    }
  }
  return texmap::uv_of(Convention::daily, best).u;
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      .exercises = {another_convention(), from_one_to_another(), is_it_mirrored()},
      .questions =
          {{"04.a",
            "The Earth's map has 2048 columns. By how many columns does the lecture's rounding "
            "shift it at America, where u is 1/4?",
            [] { return shift_at(0.25); }, "columns"},
           {"04.b",
            "A place has u = 0.1 in the lecture's convention. What is its u in the daily "
            "exercise's?",
            [] { return daily_u_at_lecture_u(0.1); }, ""}},
  };
  return chapter;
}

}  // namespace texmap::check
