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

using Turn = Vector(Vector, double);

/// The right turn, by angles that many compute.
std::vector<Mistake<Turn>> wrong_angles() {
  std::vector<Mistake<Turn>> mistakes;
  const auto wrong = [&](const char* word, double factor) {
    mistakes.push_back({word, [=](Vector p, double degrees) {
                          return turned_by(p, std::sin(factor * degrees),
                                           std::cos(factor * degrees));
                        }});
  };
  wrong("sin and cos get degrees and take them for radians: multiply by pi / 180", 1);
  wrong("pi and 180 are exchanged: radians are degrees * pi / 180", 1 / radian);
  wrong("this is half of the angle: a full turn is 2 pi, and 360 degrees", radian / 2);
  wrong("this is twice the angle: half a turn is pi, and 180 degrees", radian * 2);
  for (const double rounded : {3.14, 3.141, 3.142, 3.1415, 3.1416, 3.14159})
    wrong("your pi has too few digits: take the constant pi", rounded / 180);
  return mistakes;
}

/// Turns as many write them.
std::vector<Mistake<Turn>> wrong_turns() {
  std::vector<Mistake<Turn>> mistakes = wrong_angles();
  const auto wrong = [&](const char* word, auto turn) {
    mistakes.push_back({word, [=](Vector p, double degrees) {
                          return turn(p, std::sin(degrees * radian), std::cos(degrees * radian));
                        }});
  };
  wrong("the other way around, from +z to -x: exchange the signs of the sines",
        [](Vector p, double s, double c) { return turned_by(p, -s, c); });
  wrong("sine and cosine are exchanged: at 0 degrees your globe is turned already",
        [](Vector p, double s, double c) { return turned_by(p, c, s); });
  const char* sign = "one sine has the wrong sign: x gets z sin, z loses x sin";
  wrong(sign, [](Vector p, double s, double c) {
    return Vector{p.x * c + p.z * s, p.y, p.z * c + p.x * s};
  });
  wrong(sign, [](Vector p, double s, double c) {
    return Vector{p.x * c - p.z * s, p.y, p.z * c - p.x * s};
  });
  for (const int way : {1, -1}) {
    wrong("the new z is computed from the new x: keep the old x in a variable",
          [=](Vector p, double s, double c) {
            const double x = p.x * c + p.z * s * way;
            return Vector{x, p.y, p.z * c - x * s * way};
          });
    wrong("the new x is computed from the new z: keep the old z in a variable",
          [=](Vector p, double s, double c) {
            const double z = p.z * c - p.x * s * way;
            return Vector{p.x * c + z * s * way, p.y, z};
          });
    wrong("x and y are turned, about the z axis: turn x and z", [=](Vector p, double s, double c) {
      const Vector moved = turned_by({p.x, p.z, p.y}, s * way, c);
      return Vector{moved.x, moved.z, moved.y};
    });
    wrong("y and z are turned, about the x axis: turn x and z", [=](Vector p, double s, double c) {
      const Vector moved = turned_by({p.y, p.x, p.z}, s * way, c);
      return Vector{moved.y, moved.x, moved.z};
    });
    wrong("z is not turned: it changes, too, into z cos - x sin",
          [=](Vector p, double s, double c) {
            return Vector{p.x * c + p.z * s * way, p.y, p.z};
          });
    wrong("x is not turned: it changes, too, into x cos + z sin",
          [=](Vector p, double s, double c) {
            return Vector{p.x, p.y, p.z * c - p.x * s * way};
          });
    wrong("the cosines are missing: x turns into x cos + z sin", [=](Vector p, double s, double) {
      return Vector{p.x + p.z * s * way, p.y, p.z - p.x * s * way};
    });
  }
  wrong("the sines are missing: x turns into x cos + z sin", [](Vector p, double, double c) {
    return Vector{p.x * c, p.y, p.z * c};
  });
  for (const double y : {0., 1.}) {
    const char* only_z =
        "this is right for +z alone: add x steps along the turned x axis, (cos, -sin)";
    wrong(only_z, [=](Vector p, double s, double c) { return Vector{p.z * s, p.y * y, p.z * c}; });
    wrong(only_z, [=](Vector p, double s, double c) { return Vector{s, p.y * y, c}; });
  }
  wrong("y is missing: it stays as it is", [](Vector p, double s, double c) {
    return Vector{p.x * c + p.z * s, 0, p.z * c - p.x * s};
  });
  wrong("x and z are exchanged in what you return", [](Vector p, double s, double c) {
    return Vector{p.z * c - p.x * s, p.y, p.x * c + p.z * s};
  });
  wrong("x and z are exchanged in the new z: it is z cos - x sin",
        [](Vector p, double s, double c) {
          return Vector{p.x * c + p.z * s, p.y, p.x * c - p.z * s};
        });
  wrong("x and z are exchanged in the new x: it is x cos + z sin",
        [](Vector p, double s, double c) {
          return Vector{p.z * c + p.x * s, p.y, p.z * c - p.x * s};
        });
  wrong("x and z are exchanged: each of them keeps its cosine, and gets the sine of the other",
        [](Vector p, double s, double c) {
          return Vector{p.z * c + p.x * s, p.y, p.x * c - p.z * s};
        });
  return mistakes;
}

Exercise turn_a_direction() {
  Law<Turn> law{.right = [](Vector p, double degrees) { return rotation_y(degrees)(p); },
                .places = {{"90 degrees turn +z to +x", {Vector{0, 0, 1}, 90}},
                           {"90 degrees turn +x to -z", {Vector{1, 0, 0}, 90}},
                           {"180 degrees turn +x to -x", {Vector{1, 0, 0}, 180}},
                           {"y does not change", {Vector{0, 1, 0}, 60}},
                           {"30 degrees turn +z to (1/2, 0, 0.866)", {Vector{0, 0, 1}, 30}},
                           {"-30 degrees turn it to (-1/2, 0, 0.866)", {Vector{0, 0, 1}, -30}},
                           {"(2, 3, 6) / 7 after 40 degrees", {Vector{2. / 7, 3. / 7, 6. / 7}, 40}},
                           {"a direction at the back, (-2, 3, -6) / 7, after 200 degrees",
                            {Vector{-2. / 7, 3. / 7, -6. / 7}, 200}}},
                .mistakes = wrong_turns(),
                .tolerance = 1e-6};
  return exercise("05.1", "Vec3 turned(Vec3 p, double degrees)", std::move(law), turned,
                  globe_after({"--degrees", "60"}));
}

/// New u as many compute it.
std::vector<Mistake<double(double, double)>> wrong_u() {
  std::vector<Mistake<double(double, double)>> mistakes;
  const auto wrong = [&](const char* word, std::function<double(double, double)> function) {
    mistakes.push_back({word, std::move(function)});
  };
  const auto fraction = [](double x) { return x - std::floor(x); };
  const auto cut_off = [](double x) { return std::fmod(x, 1); };
  const auto as_it_is = [](double x) { return x; };
  const auto moved_once = [](double x) { return x >= 1 ? x - 1 : x < 0 ? x + 1 : x; };
  const auto to_one = [](double x) {
    while (x > 1) x -= 1;
    while (x < 0) x += 1;
    return x;
  };
  const auto limited = [](double x) { return std::clamp(x, 0., 1.); };
  const auto turns = [](double u, double degrees) { return u + degrees / 360; };
  const auto shown_by = [](auto range, auto place) {
    return [=](double u, double degrees) { return range(place(u, degrees)); };
  };
  wrong("u leaves 0 to 1: only the part after the decimal point counts", turns);
  wrong(
      "std::fmod and static_cast<int> cut off toward 0, so a negative number stays negative: "
      "subtract std::floor",
      shown_by(cut_off, turns));
  wrong("you remove one full turn, but there may be several", shown_by(moved_once, turns));
  wrong("u = 1 is the seam again, where u is 0: u stays less than 1", shown_by(to_one, turns));
  wrong("u = 1 is the seam again, where u is 0, and there may be several full turns",
        [=](double u, double degrees) {
          const double x = turns(u, degrees);
          return x == 1 ? x : moved_once(x);
        });
  wrong("you limit u where it must begin again: the seam becomes a stripe",
        shown_by(limited, turns));
  wrong("a negative number keeps its digits without its sign: -0.25 is 0.75. Subtract std::floor",
        shown_by([](double x) { return std::abs(std::fmod(x, 1)); }, turns));
  wrong("std::round and std::remainder go to the nearest whole number: subtract std::floor",
        shown_by([](double x) { return x - std::round(x); }, turns));
  wrong("std::round and std::remainder go to the nearest whole number: subtract std::floor",
        shown_by([](double x) { return std::remainder(x, 1); }, turns));
  wrong("std::ceil is the whole number above: subtract std::floor",
        shown_by([](double x) { return x - std::ceil(x); }, turns));
  wrong("this is the number of full turns: subtract it, the rest is u",
        shown_by([](double x) { return std::floor(x); }, turns));
  wrong("the whole turns are cut off before u is added: add first",
        [=](double u, double degrees) { return u + fraction(degrees / 360); });
  wrong("the whole turns are cut off before u is added: add first, then subtract std::floor",
        [=](double u, double degrees) { return u + cut_off(degrees / 360); });
  wrong("only whole degrees count in yours: stay with double",
        [=](double u, double degrees) { return fraction(turns(u, std::trunc(degrees))); });
  wrong("the degrees have no effect: with int, degrees / 360 is a whole number",
        [](double u, double) { return u; });
  const auto scaled = [&](const char* word, auto place) {
    wrong(word, shown_by(fraction, place));
    wrong(word, shown_by(cut_off, place));
    wrong(word, shown_by(as_it_is, place));
    wrong(word, shown_by(moved_once, place));
  };
  scaled("the angle has the wrong sign: a turn to the east adds to u",
         [=](double u, double degrees) { return turns(u, -degrees); });
  scaled("u counts full turns: divide the degrees by 360, not by 180",
         [=](double u, double degrees) { return turns(u, 2 * degrees); });
  scaled("u counts full turns, not radians: divide the degrees by 360",
         [](double u, double degrees) { return u + degrees * radian; });
  scaled("degrees are divided by 360; 2 pi is a full turn in radians",
         [](double u, double degrees) { return u + degrees / (2 * std::numbers::pi); });
  scaled("u counts full turns, not degrees: divide the degrees by 360 before you add them",
         [](double u, double degrees) { return u + degrees; });
  scaled("u and the degrees are added before they have the same unit: divide the degrees alone",
         [](double u, double degrees) { return (u + degrees) / 360; });
  scaled("the turn is added to u, not multiplied by it",
         [](double u, double degrees) { return u * degrees / 360; });
  scaled("the old u is missing: the turn is added to it",
         [](double, double degrees) { return degrees / 360; });
  const char* unit = "this is an angle in degrees: divide it by 360 to have u";
  const auto angle = [=](double u, double degrees) { return 360 * turns(u, degrees); };
  wrong(unit, angle);
  wrong(unit, [=](double u, double degrees) { return std::fmod(angle(u, degrees), 360); });
  wrong(unit, [=](double u, double degrees) { return 360 * fraction(turns(u, degrees)); });
  return mistakes;
}

Exercise u_after_a_turn() {
  Law<double(double, double)> law{
      .right = [](double u,
                  double degrees) { return wrapped_coordinate(Wrap::repeat, u + degrees / 360); },
      .places = {{"a turn by 0 degrees changes nothing", {0.25, 0.0}},
                 {"a quarter turn to the east adds 1/4", {0.25, 90.0}},
                 {"a quarter turn to the west subtracts 1/4", {0.5, -90.0}},
                 {"a turn by 4.5 degrees adds 1/80", {0.5, 4.5}},
                 {"beyond the seam u begins at 0: from 0.875 a quarter turn leads to 0.125",
                  {0.875, 90.0}},
                 {"on the seam u is 0, not 1: from 0.75 a quarter turn leads to 0", {0.75, 90.0}},
                 {"to the west, too: from 0.125 to 0.875", {0.125, -90.0}},
                 {"full turns do not count: 765 degrees are 45", {0.25, 765.0}},
                 {"-765 degrees are -45", {0.0625, -765.0}}},
      .mistakes = wrong_u(),
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

Vector turned_about_y(const Vector& p, double degrees) { return rotation_y(degrees)(p); }

using Looked = Vector(Vector, double, double);

/// One part of a look goes wrong; with `way` -1, the lean or the turn also has the wrong sign.
std::vector<Mistake<Looked>> wrong_parts(int way) {
  std::vector<Mistake<Looked>> mistakes;
  const auto wrong = [&](const char* word, std::function<Looked> function) {
    mistakes.push_back({word, std::move(function)});
  };
  const auto straight = [=](const Vector& p, double leaning) { return upright(p, way * leaning); };
  wrong("the axis leans to the eye or away from it: undo the lean with x and y",
        [=](Vector p, double leaning, double degrees) {
          const Vector q = straight({p.z, p.y, p.x}, leaning);
          return turned_about_y({q.z, q.y, q.x}, degrees);
        });
  const char* old = "you turn p: turn the direction that you have after undoing the lean";
  wrong(old, [=](Vector p, double leaning, double degrees) {
    return turned_about_y({p.x, straight(p, leaning).y, p.z}, degrees);
  });
  wrong(old, [=](Vector p, double leaning, double degrees) {
    const Vector q = straight(p, leaning);
    return Vector{turned_about_y(q, degrees).x, q.y, turned_about_y({p.x, q.y, q.z}, degrees).z};
  });
  wrong(old, [=](Vector p, double leaning, double degrees) {
    const Vector q = straight(p, leaning);
    return Vector{turned_about_y({p.x, q.y, q.z}, degrees).x, q.y, turned_about_y(q, degrees).z};
  });
  wrong("y comes from p: take that of the direction after undoing the lean",
        [=](Vector p, double leaning, double degrees) {
          const Vector q = straight(p, leaning);
          return turned_about_y({q.x, p.y, q.z}, degrees);
        });
  wrong("the new y is computed from the new x: keep the old x in a variable",
        [=](Vector p, double leaning, double degrees) {
          const double x = straight(p, leaning).x;
          return turned_about_y({x, straight({x, p.y, p.z}, leaning).y, p.z}, degrees);
        });
  wrong("the new z is computed from the new x: keep the old x in a variable",
        [=](Vector p, double leaning, double degrees) {
          const Vector q = straight(p, leaning);
          const Vector moved = turned_about_y(q, degrees);
          return Vector{moved.x, q.y, turned_about_y({moved.x, 0, q.z}, degrees).z};
        });
  wrong("the globe does not turn: after the lean, turn x and z",
        [=](Vector p, double leaning, double) { return straight(p, leaning); });
  wrong("the axis does not lean: turn x and y by the lean before you turn x and z",
        [=](Vector p, double, double degrees) { return turned_about_y(p, way * degrees); });
  wrong("one sine of the lean has the wrong sign: x and y turn, so one is added, one subtracted",
        [=](Vector p, double leaning, double degrees) {
          const Vector x = upright(p, way * leaning);
          const Vector y = upright(p, -way * leaning);
          return turned_about_y({x.x, y.y, p.z}, degrees);
        });
  wrong(
      "one sine of the turn has the wrong sign: x and z turn, so one is added, one subtracted",
      [=](Vector p, double leaning, double degrees) {
        const Vector q = upright(p, leaning);
        return Vector{turned_about_y(q, way * degrees).x, q.y, turned_about_y(q, -way * degrees).z};
      });
  return mistakes;
}

/// Looks as many write them.
std::vector<Mistake<Looked>> wrong_looks() {
  std::vector<Mistake<Looked>> mistakes;
  const auto wrong = [&](const char* word, std::function<Looked> function) {
    mistakes.push_back({word, std::move(function)});
  };
  const auto both = [](Vector p, double leaning, double degrees) {
    return turned_about_y(upright(p, leaning), degrees);
  };
  wrong("the turn comes first: your pole runs around in a circle. Undo the lean first",
        [](Vector p, double leaning, double degrees) {
          return upright(turned_about_y(p, degrees), leaning);
        });
  wrong("the axis leans to the left: undoing the lean turns (sin, cos, 0) to (0, 1, 0)",
        [=](Vector p, double leaning, double degrees) { return both(p, -leaning, degrees); });
  wrong("the turn comes first, and the axis leans to the left: undo the lean first, to (0, 1, 0)",
        [](Vector p, double leaning, double degrees) {
          return upright(turned_about_y(p, degrees), -leaning);
        });
  wrong("the turn has the wrong sign: after the lean, +z must turn to +x",
        [=](Vector p, double leaning, double degrees) { return both(p, leaning, -degrees); });
  wrong("both turns go the wrong way: the pole must come to (0, 1, 0), and then +z to +x",
        [=](Vector p, double leaning, double degrees) { return both(p, -leaning, -degrees); });
  wrong("the turn about the leaning axis is right, but the lean comes back: undo it only",
        [=](Vector p, double leaning, double degrees) {
          return upright(both(p, leaning, degrees), -leaning);
        });
  const char* unit = "sin and cos get degrees and take them for radians: multiply by pi / 180";
  for (const double of_lean : {1 / radian, 1.}) {
    for (const double of_turn : {1 / radian, 1.}) {
      if (of_lean + of_turn == 2) continue;  // both are right
      wrong(unit, [=](Vector p, double leaning, double degrees) {
        return both(p, leaning * of_lean, degrees * of_turn);
      });
    }
  }
  wrong("the two angles are exchanged: x and y turn by the lean, x and z by the turn",
        [=](Vector p, double leaning, double degrees) { return both(p, degrees, leaning); });
  wrong("both angles turn x and z: the lean is a turn of x and y",
        [](Vector p, double leaning, double degrees) {
          return turned_about_y(p, leaning + degrees);
        });
  wrong("lean is an argument: your axis always leans by 23.4 degrees",
        [=](Vector p, double, double degrees) { return both(p, lean, degrees); });
  wrong(
      "these are half of the angles: a full turn is 2 pi, and 360 degrees",
      [=](Vector p, double leaning, double degrees) { return both(p, leaning / 2, degrees / 2); });
  wrong("sine and cosine of the lean are exchanged: without a lean x and y stay as they are",
        [=](Vector p, double leaning, double degrees) { return both(p, 90 - leaning, degrees); });
  wrong("sine and cosine of both angles are exchanged: without a lean and a turn p stays as it is",
        [=](Vector p, double leaning, double degrees) {
          return both(p, 90 - leaning, 90 - degrees);
        });
  for (const int way : {1, -1}) {
    const auto parts = wrong_parts(way);
    mistakes.insert(mistakes.end(), parts.begin(), parts.end());
  }
  return mistakes;
}

Exercise a_leaning_axis() {
  const double s = std::sin(30 * radian);
  const double c = std::cos(30 * radian);
  Law<Looked> law{
      .right = [](Vector p, double leaning,
                  double degrees) { return turned_about_y(upright(p, leaning), degrees); },
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
      .mistakes = wrong_looks(),
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
                           texmap::Turntable{.degrees = 90, .frames = 24, .frame = 21}.rotation();
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
