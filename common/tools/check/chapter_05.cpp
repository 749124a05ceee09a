// The exercises of chapter 05. The lesson is the chapter's own. It uses Rotated by name; here
// this name, in the lesson's namespace, means a struct that calls the student's function.

#include "engine/run/turntable.hpp"
#include "exercises.hpp"
#include "texture/rotated.hpp"

namespace texmap::chapter_05 {

static std::function<Vec3d(Vec3d, double)> turned;
static std::function<double(double, Vec3d)> angle_to_show;
static std::function<Vec3d(Vec3d, double, double)> looked_up;
constexpr double earths_lean = 23.4;    // of its axis
constexpr Point eye_aside{7, 4.5, -2};  // from where Sydney is to be seen
constexpr double sydney = 151.2;

template <class Mapping>
struct Rotated {
  RotationY rotation;
  Mapping mapping;

  Uv<double> operator()(const Vec3d& p) const {
    // Whole degrees, as the pictures here have.
    const double degrees = std::round(std::atan2(rotation.sine, rotation.cosine) / check::radian);
    if (turned) return mapping(turned(p, degrees));
    if (looked_up) return mapping(looked_up(p, earths_lean, degrees));
    if (angle_to_show) return mapping(rotation_y(angle_to_show(sydney, eye_aside))(p));
    return mapping(rotation(p));
  }
};

}  // namespace texmap::chapter_05

#include "05_y_rotation/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_05;

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

Image globe_from_aside() {
  auto lesson = prepared<Lesson>();
  lesson.stage.camera.eye = eye_aside;
  return picture_of(lesson, 18);
}

Slips<double> wrong_angles(double longitude, Vec3d eye) {
  const auto [x, y, z] = eye;
  const double by_eye = atan2(-z, x) / radian;
  const double right = longitude - by_eye;
  return {
      {"the picture moves the other way: a positive angle looks up what lies further east", -right},
      {"subtract the eye's longitude, std::atan2(-z, x): this grows to the east, atan2(z, x) west",
       {longitude + by_eye, -longitude - by_eye}},
      {"your eye is always on +z: use the longitude of the eye",
       {longitude + 90, longitude - 90, -longitude - 90, 90 - longitude}},
      {"yours has no eye: without a turn the eye's own longitude is in the middle",
       {longitude, -longitude}},
      {"this is the eye's longitude alone", {by_eye, -by_eye}},
      {"longitude 0 is on +x: std::atan2(x, z) is 0 on +z",
       {longitude - atan2(x, z) / radian, longitude + atan2(x, z) / radian}},
      {"this shows the back of the globe", {right + 180, 180 - right}},
      {"std::atan2 returns radians: multiply by 180 / pi",
       {longitude - by_eye * radian, longitude - by_eye * radian * radian}},
      {"the answer is in degrees, not in radians and not a part of a turn",
       {right * radian, right / 360, longitude * radian - by_eye * radian}},
      {"std::atan sees only z / x, half of the directions: use std::atan2",
       {longitude - atan(-z / x) / radian, longitude + atan(z / x) / radian}},
      {"the eye's height does not count: a longitude is an angle between x and z",
       {longitude - atan2(y, x) / radian, longitude - acos(x / length(eye)) / radian,
        longitude - atan2(-z, y) / radian}},
  };
}

double right_angle(double longitude, Vec3d eye) {
  return 360 * (0.5 + longitude / 360 - uv_rtiow(eye).u);
}
/// Counted from 1 degree, which no place needs, so that rounding makes no full turn.
double without_full_turns(double degrees, double /*longitude*/, Vec3d /*eye*/) {
  return fraction((degrees - 1) / 360);
}
constexpr Place<double, Vec3d> angle_to_show_places[] = {
    {"from +z, longitude 0 needs 90 degrees: Africa faces the eye", {0, {0, 0, 8}}},
    {"from +z, longitude -90 needs none: America is there already", {-90, {0, 0, 8}}},
    {"from +x, longitude 0 needs none", {0, {3, 0, 0}}},
    {"from +x, longitude 30 needs 30 degrees", {30, {3, 0, 0}}},
    {"from -z, longitude 60 needs -30 degrees", {60, {0, 0, -5}}},
    {"from halfway between +x and +z, longitude 0 needs 45 degrees", {0, {4, 0, 4}}},
    {"the eye's height does not count: from (4, 7, 4) it is 45 degrees, too", {0, {4, 7, 4}}},
    {"from the back, (-3, 1, -4), longitude 100", {100, {-3, 1, -4}}},
    {"from (-3, -2, 4), longitude 151", {151, {-3, -2, 4}}},
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
      {"you turn the globe: turn the direction that is looked up, from +z to +x",
       look(lean, -turn)},
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

ExercisesOfChapter all_exercises_of_chapter() {
  return {
      "05",
      {exercise(turned, picture<Lesson>({"--degrees", "60"}, 18),
                {right_turn, wrong_turns, turned_places}),
       exercise(angle_to_show, globe_from_aside,
                {right_angle, wrong_angles, angle_to_show_places, without_full_turns}),
       exercise(looked_up, picture<Lesson>({"--degrees", "60"}, 18),
                {right_look, wrong_looks, looked_up_places})},
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
}

}  // namespace texmap::check
