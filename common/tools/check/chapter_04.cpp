// The exercises of chapter 04. The lesson is the chapter's own. Its ConventionMapping is this one
// here, which calls the student's functions.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises.hpp"
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
  struct Angles {
    double from_x, x_from_z, from_north;  // parts of a turn, of a turn, of half a turn
  };
  // Those who make another mistake often forget to limit y, too.
  for (const bool limited : {true, false}) {
    const auto wrong = [&](const char* word, Place2 (*function)(const Angles&)) {
      law.mistakes.push_back({word, [=](const Vector& p) {
                                const double y = limited ? std::clamp(p.y, -1.0, 1.0) : p.y;
                                return function({std::atan2(p.z, p.x) / turn,
                                                 std::atan2(p.x, p.z) / turn,
                                                 std::acos(y) / (turn / 2)});
                              }});
    };
    wrong("u runs east: here it has to run west; the sign of z says which way",
          [](const Angles& a) {
            return Place2{0.5 - a.from_x, a.from_north};
          });
    wrong("v runs up: here it has to run down from the north pole", [](const Angles& a) {
      return Place2{0.5 + a.from_x, 1 - a.from_north};
    });
    wrong("u runs east and v runs up: this is the convention of chapter 02", [](const Angles& a) {
      return Place2{0.5 - a.from_x, 1 - a.from_north};
    });
    wrong("the angles of atan2 and acos are in radians: a whole turn is 2 pi, not 360",
          [](const Angles& a) {
            return Place2{0.5 + a.from_x * turn / 360, a.from_north * turn / 2 / 180};
          });
    wrong("the 1/2 is missing in u: half of the globe has negative u", [](const Angles& a) {
      return Place2{a.from_x, a.from_north};
    });
    wrong("the arguments of atan2 are exchanged: z comes first", [](const Angles& a) {
      return Place2{0.5 + a.x_from_z, a.from_north};
    });
    if (!limited) {
      wrong("acos and asin give NaN for a y beyond 1, at the pole: limit y to -1 and 1 first",
            [](const Angles& a) {
              return Place2{0.5 + a.from_x, a.from_north};
            });
    }
  }
  return exercise("04.1", "Uv uv_of(Vec3 p)", std::move(law), uv_of, [] {
    return globe({"--convention", "daily"});
  });
}

Exercise from_one_to_another() {
  Law<double(double)> law{
      .right =
          [](double u) {
            return in_convention(Convention::lecture, Place2{u, 0.5}).u;
          },
      .places = {{"on +z, u goes from 1/4 to 0", {0.25}},
                 {"on +x, u goes from 1/2 to 1/4", {0.5}},
                 {"on -z, u goes from 3/4 to 1/2", {0.75}},
                 {"on -x, u goes from 0 to 3/4", {0.0}},
                 {"u = 0.1 becomes 0.85", {0.1}},
                 {"u = 0.95 becomes 0.7", {0.95}}},
      .mistakes =
          {{"below 0 a whole turn is missing: add 1 there (std::fmod does not)",
            [](double u) { return u - 0.25; }},
           {"from 1 on a whole turn is too much: subtract 1 there",
            [](double u) { return u + 0.75; }},
           {"this turns the other way: +z has to get u = 0, not 1/2",
            [](double u) { return u < 0.75 ? u + 0.25 : u - 0.75; }},
           {"this turns the other way, and from 1 on a whole turn is too much",
            [](double u) { return u + 0.25; }},
           {"you reflect where u - 1/4 is negative: add a whole turn there, no absolute value",
            [](double u) { return std::abs(u - 0.25); }},
           {"you cut off at 0: the first quarter comes after the others, at u + 3/4",
            [](double u) { return std::max(u - 0.25, 0.0); }},
           {"u runs the other way: both conventions run east",
            [](double u) { return u <= 0.25 ? 0.25 - u : 1.25 - u; }}},
      .tolerance = 1e-9};
  return exercise("04.2", "double lecture_u(double u)", std::move(law), lecture_u, [] {
    return globe({"--convention", "lecture"});
  });
}

Exercise is_it_mirrored() {
  using Function = bool(Place2, Place2, Place2);
  const auto steps = [](double right_e, double up_e, double right_n, double up_n) {
    const Place2 here{0.5, 0.5};
    return std::tuple{here, Place2{here.u + right_e, here.v + up_e},
                      Place2{here.u + right_n, here.v + up_n}};
  };
  Law<Function> law{
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
                  steps(0.01, -0.02, 0.02, 0.01)}},
      .mistakes = {}};
  const auto wrong = [&](const char* word, bool (*function)(double, double, double, double)) {
    law.mistakes.push_back({word, [=](Place2 here, Place2 east, Place2 north) {
                              return function(east.u - here.u, east.v - here.v, north.u - here.u,
                                              north.v - here.v);
                            }});
  };
  wrong("you look at the step to the east alone: the step to the north can be turned around, too",
        [](double u_e, double, double, double) { return u_e < 0; });
  wrong("you look at the step to the north alone: the step to the east can be turned around, too",
        [](double, double, double, double v_n) { return v_n < 0; });
  wrong("two signs that are turned around make half a turn, no mirror: multiply them",
        [](double u_e, double, double, double v_n) { return u_e < 0 || v_n < 0; });
  wrong("this is mirrored only if one of the two is turned around, and you ask for both",
        [](double u_e, double, double, double v_n) { return u_e < 0 && v_n < 0; });
  wrong("right unless the picture is turned by a quarter: the determinant has u_n * v_e, too",
        [](double u_e, double, double, double v_n) { return u_e * v_n < 0; });
  wrong("in the determinant the second product is subtracted",
        [](double u_e, double v_e, double u_n, double v_n) { return u_e * v_n + u_n * v_e < 0; });
  wrong("yes and no are exchanged: a negative determinant means mirrored",
        [](double u_e, double v_e, double u_n, double v_n) { return u_e * v_n - u_n * v_e > 0; });
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
      .questions = {{"04.a",
                     "The map has 2048 columns. By how many columns does the lecture's rounding "
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
