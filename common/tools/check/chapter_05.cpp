// The exercises of chapter 05. The lesson is the chapter's own. It uses Rotated by name; here
// this name, in the lesson's namespace, means a struct that calls the student's function.

#include "engine/run/layout_options.hpp"
#include "engine/run/turntable.hpp"
#include "exercises.hpp"
#include "texture/rotated.hpp"
#include "texture/wrap.hpp"

namespace texmap::chapter_05 {

static std::function<Vec3d(Vec3d, double)> turned;
static std::function<double(double, double)> u_after;
static std::function<Vec3d(Vec3d, double, double)> looked_up;
constexpr double earths_lean = 23.4;  // of its axis

template <class Mapping>
struct Rotated {
  RotationY rotation;
  Mapping mapping;

  Uv<double> operator()(const Vec3d& p) const {
    // Whole degrees, as the pictures here have.
    const double degrees = std::round(std::atan2(rotation.sine, rotation.cosine) / check::radian);
    if (turned) return mapping(turned(p, degrees));
    if (looked_up) return mapping(looked_up(p, earths_lean, degrees));
    if (!u_after) return mapping(rotation(p));
    const Uv<double> uv = mapping(p);
    return {u_after(uv.u, degrees), uv.v};
  }
};

}  // namespace texmap::chapter_05

#include "05_y_rotation/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_05;

/// Draws the globe from near by, turned.
std::function<Image()> globe_after(const char* degrees) {
  return picture<Lesson>({"--degrees", degrees}, 18);
}

constexpr auto in_degrees =
    "sin and cos get degrees and take them for radians: multiply by pi / 180";

/// After a turn by this sine and cosine.
Vec3d turned_by(const Vec3d& p, double s, double c) {
  return {p.x * c + p.z * s, p.y, p.z * c - p.x * s};
}
Vec3d turned_about_y(const Vec3d& p, double degrees) { return rotation_y(degrees)(p); }

/// About the x axis, from +y to +z, as many turn; here as a turn about y, of (z, x, y).
Slips<Vec3d> wrong_about_y(Vec3d p, double degrees) {
  const auto by = [&](double factor) {  // radians of a degree
    return turned_by(p, sin(factor * degrees), cos(factor * degrees));
  };
  const double sine = sin(degrees * radian), cosine = cos(degrees * radian);
  const auto [x, y, z] = p;
  const Vec3d right = turned_by(p, sine, cosine), other = turned_by({z, y, x}, sine, cosine);
  Slips<Vec3d> wrong;
  for (const int way : {1, -1}) {  // those who make another mistake often turn the other way, too
    wrong += {
        {in_degrees, by(way)},
        {"radians are degrees * pi / 180",
         {{"pi and 180 are exchanged", by(way / radian)},
          {"this is half or twice the angle", {by(way * radian / 2), by(way * radian * 2)}},
          {"this is a share of a turn", {by(way / 360.), by(way / 180.), by(way / (2 * pi))}}}},
    };
  }
  wrong += {
      {"your pi has too few digits: take the constant pi",
       {by(3.14 / 180), by(3.141 / 180), by(3.142 / 180), by(3.1415 / 180), by(3.1416 / 180),
        by(3.14159 / 180)}},
      {"the other way around, from +y to -z: exchange the signs of the sines", by(-radian)},
      {"sine and cosine are exchanged: yours is turned at 0 degrees", turned_by(p, cosine, sine)},
  };
  constexpr auto rule = "y turns into y cos - z sin, and z into z cos + y sin";
  // By the angle, the other way, and by the two in degrees.
  for (const double w : {degrees * radian, -degrees * radian, degrees, -degrees}) {
    const double s = sin(w), c = cos(w);
    const Vec3d q = turned_by(p, s, c);
    wrong += {
        {"one of the new y and z is computed from the other: keep the old ones in variables",
         {{q.x, y, z * c - q.x * s}, {x * c + q.z * s, y, q.z}}},
        {"you turn about the y axis or the z axis: turn z and y",
         {{x * c + y * s, y * c - x * s, z}, {x, y * c + z * s, z * c - y * s}}},
        {rule,
         {{"one sine has the wrong sign", {q.x, y, z * c + x * s}},
          {"one of them is not turned", {{q.x, y, z}, {x, y, q.z}}},
          {"the cosines are missing", turned_by(p, s, 1)}}},
    };
  }
  return {
      wrong,
      {rule,
       {{"the sines are missing", turned_by(p, 0, cosine)},
        {"this is right for +y alone",
         {{z * sine, 0, z * cosine},
          {sine, 0, cosine},
          {z * sine, y, z * cosine},
          {sine, y, cosine}}},
        {"z and y are exchanged", {{right.x, y, other.z}, {other.x, y, right.z}, other}}}},
  };
}

Slips<Vec3d> wrong_turns(Vec3d p, double degrees) {
  return changed(wrong_about_y({p.z, p.x, p.y}, degrees), [](const Vec3d& q) {
    return Vec3d{q.y, q.z, q.x};
  });
}

Vec3d right_turn(const Vec3d& p, double degrees) {
  const Vec3d q = turned_about_y({p.z, p.x, p.y}, degrees);
  return {q.y, q.z, q.x};
}
constexpr Place<Vec3d, double> turned_places[] = {
    {"90 degrees turn +y to +z", {{0, 1, 0}, 90}},
    {"90 degrees turn +z to -y", {{0, 0, 1}, 90}},
    {"180 degrees turn +z to -z", {{0, 0, 1}, 180}},
    {"x does not change", {{1, 0, 0}, 60}},
    {"30 degrees turn +y to (0, 0.866, 1/2)", {{0, 1, 0}, 30}},
    {"-30 degrees turn it to (0, 0.866, -1/2)", {{0, 1, 0}, -30}},
    {"22.5 degrees turn it to (0, 0.924, 0.383)", {{0, 1, 0}, 22.5}},
    {"(2, 3, 6) / 7 after 40 degrees", {{2. / 7, 3. / 7, 6. / 7}, 40}},
    {"a place at the back, (-2, 3, -6) / 7, after 200 degrees", {{-2. / 7, 3. / 7, -6. / 7}, 200}},
};

double moved_once(double x) { return x >= 1 ? x - 1 : x < 0 ? x + 1 : x; }

/// x in the range 0 to 1 as many bring it there.
std::vector<double> forms(double x) { return {fraction(x), fmod(x, 1), x, moved_once(x)}; }

Slips<double> wrong_u(double u, double degrees) {
  const double turns = degrees / 360, x = u + turns;
  const double down_to_1 = x > 0 && x == floor(x) ? 1 : fraction(x);
  return {
      {"u leaves 0 to 1: only the part after the decimal point counts", x},
      {"subtract std::floor",
       {{"std::fmod and static_cast<int> cut off toward 0, so below 0 it stays negative",
         fmod(x, 1)},
        {"you remove one full turn, but there may be several", {moved_once(x), fmod(x + 1, 1)}},
        {"-0.25 is 0.75, not 0.25", abs(fmod(x, 1))},
        {"std::round, remainder and ceil go up", {x - round(x), remainder(x, 1), x - ceil(x)}},
        {"this is the number of full turns, and the rest is u", floor(x)},
        {"add first, then cut off the whole turns", {u + fraction(turns), u + fmod(turns, 1)}}}},
      {"u = 1 is the seam again, where u is 0: u stays less than 1", down_to_1},
      {"u = 1 is the seam, u = 0, and there may be several full turns", x == 1 ? x : moved_once(x)},
      {"you limit u where it must begin again: the seam becomes a stripe", clamp(x, 0., 1.)},
      {"only whole degrees count in yours: stay with double",
       {fraction(u + trunc(degrees) / 360), u + fmod(trunc(degrees), 360) / 360}},
      {"the degrees have no effect: with int, degrees / 360 is a whole number",
       {u, u + trunc(degrees / 360), fmod(u + trunc(degrees / 360), 1)}},
      {"u counts full turns, so add degrees / 360",
       {{"the angle has the wrong sign", forms(u - turns)},
        {"you divide by 180", forms(u + 2 * turns)},
        {"you add radians", forms(u + degrees * radian)},
        {"2 pi is a full turn in radians", forms(u + degrees / (360 * radian))},
        {"you add degrees", forms(u + degrees)},
        {"you divide u, too", forms((u + degrees) / 360)},
        {"you multiply by the turn", forms(u * turns)},
        {"the old u is missing", forms(turns)}}},
      {"this is in degrees: divide it by 360", {360 * x, 360 * fmod(x, 1), 360 * fraction(x)}},
  };
}

double right_u(double u, double by) { return wrapped_coordinate(Wrap::repeat, u + by / 360); }
constexpr Place<double, double> u_after_places[] = {
    {"a turn by 0 degrees changes nothing", {0.25, 0.0}},
    {"a quarter turn to the east adds 1/4", {0.25, 90.0}},
    {"a quarter turn to the west subtracts 1/4", {0.5, -90.0}},
    {"a turn by 4.5 degrees adds 1/80", {0.5, 4.5}},
    {"beyond the seam u begins at 0: from 0.875 a quarter turn leads to 0.125", {0.875, 90.0}},
    {"on the seam u is 0, not 1: from 0.75 a quarter turn leads to 0", {0.75, 90.0}},
    {"to the west, too: from 0.125 to 0.875", {0.125, -90.0}},
    {"full turns do not count: 765 degrees are 45", {0.25, 765.0}},
    {"-765 degrees are -45", {0.0625, -765.0}},
};

/// p with a lean to the right undone.
Vec3d upright(const Vec3d& p, double degrees) {
  const double s = sin(degrees * radian), c = cos(degrees * radian);
  return {p.x * c - p.y * s, p.x * s + p.y * c, p.z};
}

Vec3d right_look(Vec3d p, double lean, double turn) {
  return turned_about_y(upright(p, lean), turn);
}

Slips<Vec3d> wrong_in_radians(Vec3d p, double lean, double turn) {
  const auto look = [&](double first, double then) { return right_look(p, first, then); };
  const auto spun = [&](const Vec3d& q) { return turned_about_y(q, turn); };
  Slips<Vec3d> wrong = {
      {"the turn comes first: your pole runs around. Undo the lean first", upright(spun(p), lean)},
      {"the axis leans to the left: (sin, cos, 0) must turn to (0, 1, 0)", look(-lean, turn)},
      {"the turn comes first, and the axis leans to the left: undo the lean first, to (0, 1, 0)",
       upright(spun(p), -lean)},
      {"the turn has the wrong sign: after the lean, +z must turn to +x", look(lean, -turn)},
      {"both turns go the wrong way: bring the pole to (0, 1, 0), +z to +x", look(-lean, -turn)},
      {"the turn about the leaning axis is right, but the lean comes back: undo it only",
       upright(look(lean, turn), -lean)},
      {in_degrees,
       {look(lean / radian, turn / radian), look(lean / radian, turn), look(lean, turn / radian)}},
      {"the lean is a turn of x and y, the turn one of x and z",
       {{"the two angles are exchanged", look(turn, lean)},
        {"both angles turn x and z", look(0, lean + turn)}}},
      {"lean is an argument: your axis always leans by 23.4 degrees", look(earths_lean, turn)},
      {"these are half of the angles: 2 pi is 360 degrees", look(lean / 2, turn / 2)},
      {"sine and cosine are exchanged: without a lean and a turn p stays as it is",
       {look(90 - lean, turn), look(90 - lean, 90 - turn)}},
  };
  const Vec3d right = upright(p, lean);
  // One part goes wrong; with `way` -1, the lean or the turn also has the wrong sign.
  for (const int way : {1, -1}) {
    const Vec3d q = upright(p, way * lean), back = upright(p, -way * lean);
    const Vec3d deep = upright({p.z, p.y, p.x}, way * lean);
    const Vec3d r = spun(q), s = spun({p.x, q.y, q.z});
    const double turned_once = look(lean, way * turn).x, turned_back = look(lean, -way * turn).z;
    wrong += {
        {"the axis leans to the eye or away: undo it with x and y", spun({deep.z, deep.y, deep.x})},
        {"you turn p: turn the direction that you have after undoing the lean",
         {spun({p.x, q.y, p.z}), {r.x, q.y, s.z}, {s.x, q.y, r.z}, {r.x, p.y, r.z}}},
        {"the new y or z is computed from the new x: keep the old x in a variable",
         {spun({q.x, upright({q.x, p.y, p.z}, way * lean).y, p.z}),
          {r.x, q.y, spun({r.x, 0, q.z}).z}}},
        {"the globe does not turn: after the lean, turn x and z", q},
        {"the axis does not lean: turn x and y by the lean, then x and z", look(0, way * turn)},
        {"one sine has the wrong sign, so that yours is no turn: one is added, one subtracted",
         {spun({q.x, back.y, p.z}), {turned_once, right.y, turned_back}}},
    };
  }
  return wrong;
}

/// The same for those who take degrees for radians, too.
Slips<Vec3d> wrong_looks(Vec3d p, double lean, double turn) {
  return {wrong_in_radians(p, lean, turn), wrong_in_radians(p, lean / radian, turn / radian)};
}

constexpr Place<Vec3d, double, double> looked_up_places[] = {
    {"without a lean and without a turn nothing changes", {{2. / 7, 3. / 7, 6. / 7}, 0, 0}},
    {"a pole leaning by 30 degrees is the north pole", {{0.5, std::numbers::sqrt3 / 2, 0}, 30, 0}},
    {"it stays the north pole while the globe turns", {{0.5, std::numbers::sqrt3 / 2, 0}, 30, 50}},
    {"without a lean, 90 degrees turn +z to +x", {{0, 0, 1}, 0, 90}},
    {"with a lean of 30 degrees, too: +z lies on the equator", {{0, 0, 1}, 30, 90}},
    {"(2, 3, 6) / 7, a lean of 23.4, a turn of 70 degrees", {{2. / 7, 3. / 7, 6. / 7}, 23.4, 70}},
};

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      "05",
      {exercise(turned, globe_after("60"), {right_turn, wrong_turns, turned_places}),
       exercise(u_after, globe_after("-150"), {right_u, wrong_u, u_after_places}),
       exercise(looked_up, globe_after("60"), {right_look, wrong_looks, looked_up_places})},
      {{"--turntable 24 begins at 90 degrees. By which angle, from 0 to 360, is the globe turned "
        "in picture 21, if the first is picture 0?",
        [] {
          const RotationY turn = Turntable{.degrees = 90, .frames = 24, .frame = 21}.rotation();
          return atan2(turn.sine, turn.cosine) / radian;
        },
        {"degrees", 1e-9},
        "How many degrees is a step, and how many steps after the first one is picture 21?",
        {{405, "one full turn more is the same angle: the answer is from 0 to 360"},
         {315, "this is the turn since picture 0, which is turned by 90 degrees already"}}},
       {"Which --degrees, at least 0 and less than 360, makes --convention lecture draw the "
        "picture that --convention rtiow draws without a turn?",
        [] {  // what undoes the other convention's u, of any point
          const Vec3d p{1, 0, 0};
          return 360 * (uv_rtiow(p).u - uv_of(Convention::lecture, p).u);
        },
        {"degrees", 0},
        "By how much does the lecture's u differ from the course's, and what does a turn add to u?",
        {{270, "the turn must add 1/4 to the lecture's u, not subtract it"}}}},
  };
  return chapter;
}

}  // namespace texmap::check
