// The exercises of chapter 05. The lesson is the chapter's own. It uses Rotated and Turntable by
// name; here those names, in the lesson's namespace, mean structs that call the student's function.
#include <cmath>
#include <numbers>

#include "engine/app/layout_options.hpp"
#include "engine/app/turntable.hpp"
#include "exercises.hpp"
#include "texture/rotated.hpp"
#include "texture/wrap.hpp"

namespace texmap::check {

static Hook<Vec3<double>(Vec3<double>, double)> turned;
static Hook<double(double, double)> u_after;
static Hook<Vec3<double>(Vec3<double>, double, double)> looked_up;
constexpr double lean = 23.4;  // of the Earth's axis

}  // namespace texmap::check

namespace texmap::chapter_05 {

struct Turn : RotationY {
  double degrees;
};

struct Turntable : texmap::Turntable {
  Turn rotation() const { return {texmap::Turntable::rotation(), degrees}; }
};

template <class Mapping>
struct Rotated {
  Turn rotation;
  Mapping mapping;

  Uv<double> operator()(const Vec3<double>& p) const {
    const double degrees = rotation.degrees;
    if (check::turned) return mapping(check::turned.yours(p, degrees));
    if (check::looked_up) return mapping(check::looked_up.yours(p, check::lean, degrees));
    if (!check::u_after) return mapping(rotation(p));
    const Uv<double> uv = mapping(p);
    return {check::u_after.yours(uv.u, degrees), uv.v};
  }
};

}  // namespace texmap::chapter_05

#include "05_y_rotation/lesson.hpp"

namespace texmap::check {
namespace {

using Vector = Vec3<double>;
constexpr double radian = std::numbers::pi / 180;  // of a degree

/// The globe from near by, after these words.
std::function<Image()> globe_after(const std::vector<std::string>& words) {
  return [words] {
    auto lesson = prepared<chapter_05::Lesson>(words);
    lesson.stage.camera.fov_y_degrees = 18;
    return render<double>(lesson, view_of(lesson.stage.camera, 400, 300));
  };
}

/// p after a turn by this sine and cosine.
Vector turned_by(const Vector& p, double s, double c) {
  return {p.x * c + p.z * s, p.y, p.z * c - p.x * s};
}

Exercise turn_a_direction() {
  const auto turn = [](auto&& sine, auto&& cosine) {
    return [=](Vector p, double degrees) {
      return turned_by(p, sine(degrees * radian), cosine(degrees * radian));
    };
  };
  const auto sine = [](double angle) { return std::sin(angle); };
  const auto cosine = [](double angle) { return std::cos(angle); };
  Law<Vector(Vector, double)> law{
      .right = [](Vector p, double degrees) { return rotation_y(degrees)(p); },
      .places = {{"90 degrees turn +z to +x", {Vector{0, 0, 1}, 90}},
                 {"90 degrees turn +x to -z", {Vector{1, 0, 0}, 90}},
                 {"180 degrees turn +x to -x", {Vector{1, 0, 0}, 180}},
                 {"y does not change", {Vector{0, 1, 0}, 60}},
                 {"30 degrees turn +z to (1/2, 0, 0.866)", {Vector{0, 0, 1}, 30}},
                 {"-30 degrees turn it to (-1/2, 0, 0.866)", {Vector{0, 0, 1}, -30}},
                 {"(2, 3, 6) / 7 after 40 degrees", {Vector{2. / 7, 3. / 7, 6. / 7}, 40}},
                 {"a direction at the back, (-2, 3, -6) / 7, after 200 degrees",
                  {Vector{-2. / 7, 3. / 7, -6. / 7}, 200}}},
      .mistakes = {{"sin and cos get degrees and take them for radians: multiply by pi / 180",
                    [](Vector p, double degrees) {
                      return turned_by(p, std::sin(degrees), std::cos(degrees));
                    }},
                   {"the other way around, from +z to -x: exchange the signs of the sines",
                    turn([](double angle) { return -std::sin(angle); }, cosine)},
                   {"sine and cosine are exchanged: at 0 degrees your globe is turned already",
                    turn(cosine, sine)},
                   {"this is half of the angle: a full turn is 2 pi, and 360 degrees",
                    [](Vector p, double degrees) { return rotation_y(degrees / 2)(p); }},
                   {"the new z is computed from the new x: keep the old x in a variable",
                    [](Vector p, double degrees) {
                      const Vector moved = rotation_y(degrees)(p);
                      return Vector{
                          moved.x, moved.y,
                          p.z * std::cos(degrees * radian) - moved.x * std::sin(degrees * radian)};
                    }},
                   {"x and y are turned, about the z axis: turn x and z",
                    [](Vector p, double degrees) {
                      const Vector moved = rotation_y(degrees)(Vector{p.x, p.z, p.y});
                      return Vector{moved.x, moved.z, moved.y};
                    }}},
      .tolerance = 1e-6};
  return exercise("05.1", "Vec3 turned(Vec3 p, double degrees)", std::move(law), turned,
                  globe_after({"--degrees", "60"}));
}

Exercise u_after_a_turn() {
  const auto turns = [](double u, double degrees) { return u + degrees / 360; };
  const auto fraction = [](double x) { return x - std::floor(x); };
  Law<double(double, double)> law{
      .right = [=](double u,
                   double degrees) { return wrapped_coordinate(Wrap::repeat, turns(u, degrees)); },
      .places = {{"a turn by 0 degrees changes nothing", {0.25, 0.0}},
                 {"a quarter turn to the east adds 1/4", {0.25, 90.0}},
                 {"a quarter turn to the west subtracts 1/4", {0.5, -90.0}},
                 {"beyond the seam u begins at 0: from 0.875 a quarter turn leads to 0.125",
                  {0.875, 90.0}},
                 {"to the west, too: from 0.125 to 0.875", {0.125, -90.0}},
                 {"full turns do not count: 765 degrees are 45", {0.25, 765.0}},
                 {"-765 degrees are -45", {0.0625, -765.0}}},
      .mistakes = {{"u leaves 0 to 1: only the part after the decimal point counts", turns},
                   {"std::fmod and static_cast<int> cut off toward 0, so a negative number stays "
                    "negative: subtract std::floor",
                    [=](double u, double degrees) { return std::fmod(turns(u, degrees), 1); }},
                   {"you remove one full turn, but there may be several",
                    [=](double u, double degrees) {
                      const double x = turns(u, degrees);
                      return x >= 1 ? x - 1 : x < 0 ? x + 1 : x;
                    }},
                   {"you limit u where it must begin again: the seam becomes a stripe",
                    [=](double u, double degrees) {
                      return std::clamp(turns(u, degrees), 0., 1.);
                    }},
                   {"the angle has the wrong sign: a turn to the east adds to u",
                    [=](double u, double degrees) { return fraction(turns(u, -degrees)); }},
                   {"u counts full turns: divide the degrees by 360, not by 180",
                    [=](double u, double degrees) { return fraction(turns(u, 2 * degrees)); }},
                   {"u counts full turns, not radians: divide the degrees by 360",
                    [=](double u, double degrees) { return fraction(u + degrees * radian); }}},
      .tolerance = 1e-9};
  return exercise("05.2", "double u_after(double u, double degrees)", std::move(law), u_after,
                  globe_after({"--degrees", "-150"}));
}

/// p with a lean to the right undone.
Vector upright(const Vector& p, double degrees) {
  const double s = std::sin(degrees * radian);
  const double c = std::cos(degrees * radian);
  return {p.x * c - p.y * s, p.x * s + p.y * c, p.z};
}

Exercise a_leaning_axis() {
  const auto turn = [](const Vector& p, double degrees) { return rotation_y(degrees)(p); };
  const double s = std::sin(30 * radian);
  const double c = std::cos(30 * radian);
  Law<Vector(Vector, double, double)> law{
      .right = [=](Vector p, double leaning,
                   double degrees) { return turn(upright(p, leaning), degrees); },
      .places = {{"without a lean and without a turn nothing changes",
                  {Vector{2. / 7, 3. / 7, 6. / 7}, 0, 0}},
                 {"a pole that leans by 30 degrees is the mapping's north pole",
                  {Vector{s, c, 0}, 30, 0}},
                 {"it stays the north pole while the globe turns", {Vector{s, c, 0}, 30, 50}},
                 {"without a lean, 90 degrees turn +z to +x", {Vector{0, 0, 1}, 0, 90}},
                 {"with a lean of 30 degrees, too: +z lies on the equator",
                  {Vector{0, 0, 1}, 30, 90}},
                 {"(2, 3, 6) / 7 after a lean of 23.4 and a turn of 70 degrees",
                  {Vector{2. / 7, 3. / 7, 6. / 7}, 23.4, 70}}},
      .mistakes = {{"the turn comes first: your pole runs around in a circle. Undo the lean first",
                    [=](Vector p, double leaning, double degrees) {
                      return upright(turn(p, degrees), leaning);
                    }},
                   {"the axis leans to the left: undoing the lean turns (sin, cos, 0) to (0, 1, 0)",
                    [=](Vector p, double leaning, double degrees) {
                      return turn(upright(p, -leaning), degrees);
                    }},
                   {"the turn has the wrong sign: after the lean, +z must turn to +x",
                    [=](Vector p, double leaning, double degrees) {
                      return turn(upright(p, leaning), -degrees);
                    }},
                   {"sin and cos get degrees and take them for radians: multiply by pi / 180",
                    [=](Vector p, double leaning, double degrees) {
                      return turn(upright(p, leaning / radian), degrees / radian);
                    }},
                   {"the axis does not lean: turn x and y by the lean before you turn x and z",
                    [=](Vector p, double, double degrees) { return turn(p, degrees); }},
                   {"the globe does not turn: after the lean, turn x and z",
                    [=](Vector p, double leaning, double) { return upright(p, leaning); }}},
      .tolerance = 1e-6};
  return exercise("05.3", "Vec3 looked_up(Vec3 p, double lean, double turn)", std::move(law),
                  looked_up, globe_after({"--degrees", "60"}));
}

/// The first angle, in whole degrees, at which these words draw the picture of an unturned globe.
double degrees_like_unturned(const std::vector<std::string>& words) {
  const Image unturned = globe_after({"--degrees", "0"})();
  for (int degrees = 0; degrees < 360; degrees += 10) {
    auto with_angle = words;
    with_angle.insert(with_angle.end(), {"--degrees", std::to_string(degrees)});
    if (globe_after(with_angle)() == unturned) return degrees;
  }
  return std::nan("");
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      .exercises = {turn_a_direction(), u_after_a_turn(), a_leaning_axis()},
      .questions = {{"05.a",
                     "--turntable 24 begins at 90 degrees. By which angle, from 0 to 360, is the "
                     "globe turned in picture 21, if the first is picture 0?",
                     [] {
                       const auto turn =
                           texmap::Turntable{.degrees = 90, .frames = 24}.rotation(21);
                       const double angle = std::atan2(turn.sine, turn.cosine) / radian;
                       return angle < 0 ? angle + 360 : angle;
                     },
                     "degrees", 1e-9},
                    {"05.b",
                     "Which --degrees, from 0 to 350, makes --convention lecture draw the picture "
                     "that --convention rtiow draws without a turn?",
                     [] {
                       return degrees_like_unturned({"--convention", "lecture"});
                     },
                     "degrees", 0}},
  };
  return chapter;
}

}  // namespace texmap::check
