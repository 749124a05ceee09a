// The exercises of chapter 04. The lesson is the chapter's own. Its ConventionMapping is this one
// here, which calls the student's functions.
#include <algorithm>
#include <cmath>
#include <initializer_list>
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
std::function<Image()> globe_after(const std::vector<std::string>& words) {
  return [words] {
    auto lesson = prepared<chapter_04::Lesson>(words);
    lesson.stage.camera.fov_y_degrees = 18;
    return picture_of(lesson);
  };
}

Slips<Place2> wrong_places(Vector p) {
  const double u = 0.5 + std::atan2(p.z, p.x) / turn;
  Slips<Place2> wrong;
  // Those who make another mistake often forget to limit y, too.
  for (const double y : {std::clamp(p.y, -1.0, 1.0), p.y}) {
    const double v = 0.5 - std::asin(y) / (turn / 2);
    wrong += {
        {"u runs east: here it has to run west; the sign of z says which way", {1 - u, v}},
        {"v runs up: here it has to run down from the north pole", {u, 1 - v}},
        {"u runs east and v runs up: this is the convention of chapter 02", {1 - u, 1 - v}},
    };
  }
  wrong += {{"acos and asin give NaN for a y beyond 1, at the pole: limit y to -1 and 1 first",
             {u, 0.5 - std::asin(p.y) / (turn / 2)}}};
  return wrong += map_slips({p.x, -p.y, -p.z});
}

Exercise another_convention() {
  const double r = std::sqrt(0.5);
  Law<Place2(Vector)> law{
      .right = [](const Vector& p) { return texmap::uv_of(Convention::daily, p); },
      .places = {{"on +x, u is 1/2 and v is 1/2", {{1, 0, 0}}},
                 {"on +z, u is 3/4", {{0, 0, 1}}},
                 {"on -z, u is 1/4", {{0, 0, -1}}},
                 {"45 degrees north of +x, v is 1/4", {{r, r, 0}}},
                 {"45 degrees south of +x, v is 3/4", {{r, -r, 0}}},
                 {"halfway between +x and +z, u is 5/8", {{r, 0, r}}},
                 {"in the direction (-2, 1, 2) / 3", {{-2. / 3, 1. / 3, 2. / 3}}},
                 {"at the north pole v is 0, also where rounding made y a little more than 1",
                  {{1e-12, 1 + 0x1p-52, 0}}}},
      .slips = wrong_places,
      .tolerance = 1e-6};
  return exercise("04.1", "Uv uv_of(Vec3 p)", std::move(law), uv_of,
                  globe_after({"--convention", "daily"}));
}

Slips<double> wrong_quarters(double u) {
  const bool first = u < 0.25;  // the first quarter
  const double less = u - 0.25;
  const auto part = [](double x) { return x - std::floor(x); };
  Slips<double> wrong = {
      {"below 0 a whole turn is missing: add 1 there (std::fmod does not)", less},
      {"from 1 on a whole turn is too much: subtract 1 there", u + 0.75},
      {"this turns the other way: +z has to get u = 0, not 1/2", part(u + 0.25)},
      {"this turns the other way, and from 1 on a whole turn is too much", u + 0.25},
      {"this turns the other way, and below 0 a whole turn is missing", u - 0.75},
      {"at u = 1/4 you give 1, and that is 0: < 0.25 there, not <=", u <= 0.25 ? u + 0.75 : less},
      {"the two cases are exchanged: u - 1/4 is negative where u is less than 1/4",
       first ? less : u + 0.75},
      {"u stays as it was: subtract 0.25 (1 / 4 is 0 in C++, and so is 3 / 4)", u},
      {"three quarters stay as they were: there it is u - 0.25 (in C++ 1 / 4 is 0)",
       first ? u + 0.75 : u},
      {"the first quarter stays as it was: there it is u + 0.75 (in C++ 3 / 4 is 0)",
       first ? u : less},
      {"you reflect where u - 1/4 is negative: add a whole turn there, no absolute value",
       std::abs(less)},
      {"you cut off at 0: the first quarter comes after the others, at u + 3/4",
       std::max(less, 0.0)},
      {"you cut off at 1: the other quarters come before the first one, at u - 1/4",
       std::min(u + 0.75, 1.0)},
  };
  for (const double value : {u + 1, u + 0.25, less + 0.5, 0.75, 1.0, 0.75 - u, 1 - u, 1 - less}) {
    wrong +=
        {{"where u - 1/4 is negative, add a whole turn to it: u - 1/4 + 1", first ? value : less}};
  }
  wrong += {{"u is in turns, not in radians: a whole turn is 1", first ? less + turn : less}};
  for (const double quarter : {turn / 4, 90.0}) {
    for (const double whole : {0.0, 1.0, 4 * quarter}) {
      wrong += {{"u is in turns: a quarter of a turn is 0.25",
                 u < quarter ? u - quarter + whole : u - quarter}};
    }
  }
  wrong += {
      {"+z is at u = 1/4, so the two differ by a quarter of a turn, not by half",
       {part(u + 0.5), u - 0.5, u + 0.5}},
      {"u moves by a quarter of a turn: subtract it, do not multiply or divide", {u * 0.25, u * 4}},
      {"u runs the other way: both conventions run east",
       {part(-less), -less, 1 - less, part(0.75 - u), 0.75 - u, part(1 - u), 1 - u}},
  };
  return wrong;
}

double right_lecture_u(double u) { return in_convention(Convention::lecture, Place2{u, 0.5}).u; }

Exercise from_one_to_another() {
  Law<double(double)> law{.right = right_lecture_u,
                          .places = {{"on +z, u goes from 1/4 to 0", {0.25}},
                                     {"on +x, u goes from 1/2 to 1/4", {0.5}},
                                     {"on -z, u goes from 3/4 to 1/2", {0.75}},
                                     {"on -x, u goes from 0 to 3/4", {0.0}},
                                     {"u = 0.1 becomes 0.85", {0.1}},
                                     {"u = 0.95 becomes 0.7", {0.95}}},
                          .slips = wrong_quarters};
  return exercise("04.2", "double lecture_u(double u)", std::move(law), lecture_u,
                  globe_after({"--convention", "lecture"}));
}

/// Whether each number is below 0, which means mirrored for a determinant; and above 0, as those
/// ask who have exchanged yes and no, too.
std::vector<bool> either_sign(std::initializer_list<double> numbers) {
  std::vector<bool> mirrored;
  for (const double number : numbers) mirrored.insert(mirrored.end(), {number < 0, 0 < number});
  return mirrored;
}

Slips<bool> wrong_mirrors(Place2 here, Place2 east, Place2 north) {
  const double u_e = east.u - here.u;
  const double v_e = east.v - here.v;
  const double u_n = north.u - here.u;
  const double v_n = north.v - here.v;
  const double product = u_e * v_n;
  Slips<bool> wrong = {
      {"this is never true: multiply the signs of east - here and north - here, or take all four",
       false},
      {"this is always true: only a negative determinant means mirrored", true},
      {"yes and no are exchanged: a negative determinant means mirrored", product > u_n * v_e},
      {"you look at the step to the east alone: the step to the north can be turned around, too",
       either_sign({u_e})},
      {"you look at the step to the north alone: the step to the east can be turned around, too",
       either_sign({v_n})},
      {"two signs that are turned around make half a turn, no mirror: multiply them",
       {u_e < 0 || v_n < 0, 0 < u_e || 0 < v_n}},
      {"this is mirrored only if one of the two is turned around: multiply the signs",
       u_e > 0 && v_n > 0},
      {"this is mirrored only if one of the two is turned around, and you ask for both",
       u_e < 0 && v_n < 0},
      {"right unless the picture is slanted or turned by a quarter: subtract u_n * v_e, too",
       product < 0},
      {"yes and no are exchanged, and a picture turned by a quarter needs the whole determinant",
       {product > 0, product >= 0}},
      {"in the determinant the second product is subtracted", either_sign({product + u_n * v_e})},
      {"this is half of the determinant alone: it is u_e * v_n - u_n * v_e",
       either_sign({-u_n * v_e})},
      {"this is the dot product: the determinant is u_e * v_n - u_n * v_e",
       either_sign({u_e * u_n + v_e * v_n})},
      {"the determinant is u_e * v_n - u_n * v_e: yours has other factors",
       either_sign({u_e * u_n, v_e * v_n, u_e * u_n - v_e * v_n, u_e * v_e - u_n * v_n,
                    product - u_n * v_n})},
      {"the step to the east can be turned around, or the one to the north: multiply the two signs",
       {u_e < 0 && v_n > 0, u_e >= 0 || v_n <= 0, u_e > 0 && v_n < 0, u_e <= 0 || v_n >= 0}},
      {"the step to the east moves u if nothing is turned, and the step to the north moves v",
       either_sign({v_e, u_n})},
      {"the signs are multiplied, not added", u_e + v_n < 0},
      {"a product of 0 says that the picture is turned by a quarter: take the whole determinant",
       product <= 0},
  };
  // Those who do not subtract `here` from both do so from none or from one.
  return wrong += {{"these are places, not steps: subtract here from east and from north first",
                    either_sign({east.u * north.v - north.u * east.v, u_e * north.v - north.u * v_e,
                                 u_e * north.v + north.u * v_e, east.u * v_n - u_n * east.v,
                                 east.u * v_n + u_n * east.v})}};
}

Exercise is_it_mirrored() {
  const auto steps = [](double right_e, double up_e, double right_n, double up_n) {
    const Place2 here{0.5, 0.5};
    return std::tuple{here, Place2{here.u + right_e, here.v + up_e},
                      Place2{here.u + right_n, here.v + up_n}};
  };
  Law<bool(Place2, Place2, Place2)> law{
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
      .slips = wrong_mirrors};
  return exercise("04.3", "bool is_mirrored(Uv here, Uv east, Uv north)", std::move(law),
                  is_mirrored, globe_after({"--convention", "daily", "--texture", "uv_map.png"}));
}

/// The daily exercise's u where the lecture's is 0.1.
double daily_u() {
  const double u = 0.1 + 0.25;  // in chapter 02's convention
  return in_convention(Convention::daily, Place2{u, 0.5}).u;
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      {another_convention(), from_one_to_another(), is_it_mirrored()},
      {{"04.a",
        "The Earth's map has 2048 columns. By how many columns does the lecture's rounding shift "
        "it at America, where u is 1/4?",
        [] { return 0.25 * 2048 - 0.25 * 2047; }, "columns"},
       {"04.b",
        "A place has u = 0.1 in the lecture's convention. What is its u in the daily exercise's?",
        daily_u, ""}},
  };
  return chapter;
}

}  // namespace texmap::check
