// The exercises of chapter 04. The lesson is the chapter's own. Its ConventionMapping is this one
// here, which calls the student's functions.
#include "exercises.hpp"
#include "map_mistakes.hpp"
#include "published/uv.hpp"
#include "texture/conventions.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::chapter_04 {

static std::function<Uv<double>(Vec3d)> uv_of;
static std::function<double(double)> lecture_u;
static std::function<bool(Uv<double>, Uv<double>, Uv<double>)> is_mirrored;

/// Whether the student's function calls this convention mirrored. It gets the (u, v) of one point
/// that the picture shows, and of two neighbors.
static bool mirrors(Convention convention) {
  constexpr double step = 0.01;
  const auto place = [=](double u, double v) {
    const Uv<double> uv = texmap::uv_of(convention, direction_rtiow(Uv<double>{u, v}));
    return Uv<double>{uv.u, v_axis_of(convention) == VAxis::up ? uv.v : 1 - uv.v};
  };
  return is_mirrored(place(0.3, 0.6), place(0.3 + step, 0.6), place(0.3, 0.6 + step));
}

struct ConventionMapping {
  Convention convention = Convention::rtiow;

  Uv<double> operator()(const Vec3d& p) const {
    if (uv_of) return uv_of(p);
    if (lecture_u) {
      const Uv<double> uv = uv_rtiow(p);
      return {lecture_u(uv.u), uv.v};
    }
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

constexpr double turn = 2 * pi;

/// Draws the globe from near by, in this convention.
std::function<Image()> globe_in(const char* convention, const char* texture = "earth.png") {
  return picture<Lesson>({"--convention", convention, "--texture", texture}, 18);
}

Slips<Place2> wrong_places(Vec3d p) {
  const double u = 0.5 + atan2(p.z, p.x) / turn;
  Slips<Place2> wrong;
  // Those who make another mistake often forget to limit y, too.
  for (const double y : {clamp(p.y, -1.0, 1.0), p.y}) {
    const double v = 0.5 - asin(y) / (turn / 2);
    wrong += {
        {"u runs east: here it has to run west; the sign of z says which way", {1 - u, v}},
        {"v runs up: here it has to run down from the north pole", {u, 1 - v}},
        {"u runs east and v runs up: this is the convention of chapter 02", {1 - u, 1 - v}},
    };
  }
  wrong += {{"acos and asin give NaN for a y beyond 1, at the pole: limit y to -1 and 1 first",
             {u, 0.5 - asin(p.y) / (turn / 2)}}};
  return wrong += map_slips({p.x, -p.y, -p.z}, {from_half, from_0}, wrong_halves);
}

Place2 right_place(const Vec3d& p) { return texmap::uv_of(Convention::daily, p); }
constexpr Place<Vec3d> uv_of_places[] = {
    {"on +x, u is 1/2 and v is 1/2", {{1, 0, 0}}},
    {"on +z, u is 3/4", {{0, 0, 1}}},
    {"on -z, u is 1/4", {{0, 0, -1}}},
    {"45 degrees north of +x, v is 1/4", {{half_root, half_root, 0}}},
    {"45 degrees south of +x, v is 3/4", {{half_root, -half_root, 0}}},
    {"halfway between +x and +z, u is 5/8", {{half_root, 0, half_root}}},
    {"in the direction (-2, 1, 2) / 3", {{-2. / 3, 1. / 3, 2. / 3}}},
    {"at the north pole v is 0, also where rounding made y more than 1", {{1e-12, 1 + 0x1p-52, 0}}},
};

Slips<double> wrong_quarters(double u) {
  const bool q1 = u < 0.25;  // the first quarter
  const double lo = u - 0.25, hi = u + 0.75;
  const auto in_q1 = [=](double value) { return q1 ? value : lo; };
  const auto less = [=](double quarter, double whole) {
    return u - quarter + (u < quarter ? whole : 0);
  };
  return {
      {"below 0 a whole turn is missing: add 1 there (std::fmod does not)", lo},
      {"from 1 on a whole turn is too much: subtract 1 there", hi},
      {"this turns the other way: +z has to get u = 0, not 1/2",
       {fraction(u + 0.25), u > 0.75 ? u - 0.75 : u + 0.25, u + 0.25, u - 0.75}},
      {"subtract 0.25, and where that is below 0 add 1 (in C++ 1 / 4 is 0)",
       {{"at u = 1/4 you give 1, and that is 0, so not <=", u <= 0.25 ? hi : lo},
        {"the two cases are exchanged", q1 ? lo : hi},
        {"u stays as it was, in a part or in all of the turn", {u, q1 ? hi : u, q1 ? u : lo}},
        {"you multiply or divide", {u * 0.25, u * 4}}}},
      {"where u - 1/4 is negative, add a whole turn, 1, to it",
       {{"you reflect there by the absolute value", abs(lo)},
        {"you cut off at 0, or at 1", {max(lo, 0.0), min(hi, 1.0)}},
        {"radians and degrees are no turns", {in_q1(lo + turn), in_q1(lo + 360)}},
        {"yours is another number",
         {in_q1(u + 1), in_q1(u + 0.25), in_q1(u + 0.5), in_q1(0.75), in_q1(1), in_q1(0.75 - u),
          in_q1(1 - u), in_q1(1 - lo)}}}},
      {"u is in turns: a quarter of a turn is 0.25",
       {less(turn / 4, 0), less(turn / 4, 1), less(turn / 4, turn), less(90, 0), less(90, 1),
        less(90, 360)}},
      {"they differ by a quarter of a turn, not by half", {fraction(u + 0.5), u - 0.5, u + 0.5}},
      {"u runs the other way: both conventions run east",
       {fraction(-lo), -lo, 1 - lo, fraction(0.75 - u), 0.75 - u, fraction(1 - u), 1 - u}},
  };
}

double right_u(double u) { return in_convention(Convention::lecture, Place2{u, 0.5}).u; }
constexpr Place<double> lecture_u_places[] = {
    {"on +z, u goes from 1/4 to 0", {0.25}},   {"on +x, u goes from 1/2 to 1/4", {0.5}},
    {"on -z, u goes from 3/4 to 1/2", {0.75}}, {"on -x, u goes from 0 to 3/4", {0.0}},
    {"u = 0.1 becomes 0.85", {0.1}},           {"u = 0.95 becomes 0.7", {0.95}},
};

/// Whether each number is below 0, which means mirrored for a determinant; and above 0, as those
/// ask who have exchanged yes and no, too.
std::vector<bool> signs(std::initializer_list<double> numbers) {
  std::vector<bool> mirrored;
  for (const double x : numbers) mirrored.insert(mirrored.end(), {x < 0, 0 < x});
  return mirrored;
}

Slips<bool> wrong_mirrors(Place2 here, Place2 east, Place2 north) {
  const double u_e = east.u - here.u, v_e = east.v - here.v;
  const double u_n = north.u - here.u, v_n = north.v - here.v;
  const double product = u_e * v_n;
  return {
      {"only a negative determinant means mirrored",
       {{"this is never true, perhaps of products as int", false},
        {"this is always true", true},
        {"yes and no are exchanged", product > u_n * v_e}}},
      {"you look at the step to the east or north alone: the other can turn, too",
       signs({u_e, v_n})},
      {"multiply the signs, as it is mirrored if one of the two steps is turned around",
       {{"two signs make half a turn, no mirror", {u_e < 0 || v_n < 0, 0 < u_e || 0 < v_n}},
        {"you ask for both or none", {u_e > 0 && v_n > 0, u_e < 0 && v_n < 0}},
        {"you ask for one of them alone",
         {u_e < 0 && v_n > 0, u_e >= 0 || v_n <= 0, u_e > 0 && v_n < 0, u_e <= 0 || v_n >= 0}},
        {"the signs are not added", u_e + v_n < 0}}},
      {"the determinant is u_e * v_n - u_n * v_e",
       {{"right unless the picture is slanted or turned by a quarter", product < 0},
        {"yes and no are exchanged, and half of it is missing", {product > 0, product >= 0}},
        {"a product of 0 says that the picture is turned by a quarter", product <= 0},
        {"the second product is subtracted", signs({product + u_n * v_e})},
        {"this is half of it alone", signs({-u_n * v_e})},
        {"this is the dot product", signs({u_e * u_n + v_e * v_n})},
        {"yours has other factors", signs({u_e * u_n, v_e * v_n, u_e * u_n - v_e * v_n,
                                           u_e * v_e - u_n * v_n, product - u_n * v_n})}}},
      {"if nothing is turned, a step to the east moves u, one to the north v", signs({v_e, u_n})},
      {"angles begin again at 360 degrees: two of them do not say on which side north is",
       {atan2(v_n, u_n) < atan2(v_e, u_e)}},
      // Those who do not subtract `here` from both do so from none or from one.
      {"these are places, not steps: subtract here from east and from north first",
       signs({east.u * north.v - north.u * east.v, u_e * north.v - north.u * v_e,
              u_e * north.v + north.u * v_e, east.u * v_n - u_n * east.v,
              east.u * v_n + u_n * east.v})},
  };
}

/// From (0.5, 0.5), in hundredths.
constexpr std::tuple<Place2, Place2, Place2> to(int right_e, int up_e, int right_n, int up_n) {
  const auto at = [](int x, int y) { return Place2{0.5 + x * 0.01, 0.5 + y * 0.01}; };
  return {at(0, 0), at(right_e, up_e), at(right_n, up_n)};
}
constexpr Place<Place2, Place2, Place2> is_mirrored_places[] = {
    {"east is to the right, north is up: as printed", to(1, 0, 0, 1)},
    {"east is to the left, north is up: mirrored", to(-1, 0, 0, 1)},
    {"east is to the right, north is down: upside down, and mirrored", to(1, 0, 0, -1)},
    {"east is to the left, north is down: turned by half a turn, not mirrored", to(-1, 0, 0, -1)},
    {"east is up, north is to the left: turned by a quarter, not mirrored", to(0, 1, -1, 0)},
    {"east is up, north is to the right: turned by a quarter, and mirrored", to(0, 1, 1, 0)},
    {"both slanted: turned by an eighth, not mirrored", to(1, -2, 2, 1)},
    {"east is at (+0.01, +0.02), north at (+0.01, +0.01) from here: mirrored", to(1, 2, 1, 1)},
    {"east is at (-0.02, +0.01), north at (-0.01, +0.01) from here: mirrored", to(-2, 1, -1, 1)},
    {"east is at (+0.02, +0.01), north at (-0.01, +0.01) from here: not mirrored", to(2, 1, -1, 1)},
    {"east is at (+0.01, +0.02), north at (-0.01, +0.01) from here: not mirrored", to(1, 2, -1, 1)},
    {"east is at (+0.01, +0.02), north at (-0.02, -0.01): not mirrored", to(1, 2, -2, -1)},
};

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      "04",
      {exercise(chapter_04::uv_of, globe_in("daily"), {right_place, wrong_places, uv_of_places}),
       exercise(lecture_u, globe_in("lecture"), {right_u, wrong_quarters, lecture_u_places}),
       exercise(is_mirrored, globe_in("daily", "uv_map.png"),
                {[](Place2 here, Place2 east, Place2 north) {
                   const auto flat = [&](Place2 p) { return Vec3d{p.u - here.u, p.v - here.v, 0}; };
                   return cross(flat(east), flat(north)).z < 0;
                 },
                 wrong_mirrors, is_mirrored_places})},
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
  return chapter;
}

}  // namespace texmap::check
