// The exercise of chapter 11. The lesson's Bumps is here a struct that scratches its heights, by
// the student's function.
#include "11_bump_and_normal_maps/sheets.hpp"
#include "engine/run/bump_options.hpp"
#include "exercises.hpp"
#include "texture/bump.hpp"
#include "texture/normal_map.hpp"

namespace texmap::chapter_11 {

static std::function<Vec3d(Vec3d, Vec3d)> scratched;

/// Members as in texmap::Bumps, in the order in which the lesson names them.
template <class Height>
struct Bumps {
  Height height;
  double relief = 1;
  BumpForm form = BumpForm::exact;
  SlopeFrom slopes = SlopeFrom::duals;
  double step = 1e-3;

  Vec3d operator()(const Hit<double>& hit, double curvature) const {
    const Vec3d& n = hit.normal;
    const Vec3d east = normalize(Vec3d{n.z, 0, -n.x});
    const Vec3d north = cross(n, east);
    const auto height_at = [&](const Vec3d& offset) {
      return relief * height(moved(hit, offset, curvature)).r;
    };
    const double here = height_at({});
    const Slope<double> slope{here, (height_at(east * step) - here) / step,
                              (height_at(north * step) - here) / step};
    const Vec3d raised = raised_normal(n, {east, north}, slope, curvature, form);
    const Vec3d parts =
        scratched({dot(raised, east), dot(raised, north), dot(raised, n)},
                  normalize(Vec3d{0.5 * std::sin(60 * n.y), 0.5 * std::sin(40 * n.x), 1}));
    return normalize(east * parts.x + north * parts.y + n * parts.z);
  }
};

struct BumpOptions : texmap::BumpOptions {
  template <class Height>
  void apply_to(Bumps<Height>& bumps) const {
    bumps.relief = relief;
    bumps.form = form;
  }
};

struct Lesson;
/// The program's sheets and turntable are not drawn here.
inline void show_bumps(Lesson&, Session&) {}

}  // namespace texmap::chapter_11

#include "11_bump_and_normal_maps/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_11;

Vec3d right_normal(Vec3d bricks, Vec3d scratches) {
  return normalize(bricks * (1 / bricks.z) + scratches * (1 / scratches.z) - Vec3d{0, 0, 1});
}

Slips<Vec3d> wrong_normals(Vec3d bricks, Vec3d scratches) {
  const Vec3d sum = bricks + scratches, b = bricks * (1 / bricks.z),
              s = scratches * (1 / scratches.z);
  const auto leaning = [](const Vec3d& slopes, double z) { return Vec3d{slopes.x, slopes.y, z}; };
  const auto root = [](const Vec3d& v) { return sqrt(max(1 - v.x * v.x - v.y * v.y, 0.0)); };
  const Slips<Vec3d> normals = {
      {"the sum of the normals is their mean direction: both look flatter. Add slopes, not normals",
       sum},
      {"x and y of a normal are slopes divided by its length: divide by z first",
       {leaning(sum, bricks.z * scratches.z), leaning(sum, 1), leaning(sum, bricks.z),
        leaning(sum, scratches.z), leaning(sum, root(sum))}},
      {"slopes add up, and here you take their mean: both look half as high", b + s},
      {"this is one of the two alone", {bricks, scratches}},
      {"the slopes have the wrong sign: bumps look like dents", leaning(b * -1. - s, 1)},
      {"the scratches have the wrong sign: they look like ridges", leaning(b - s, 1)},
      {"the third number is 1, that of the flat wall",
       {leaning(b + s, 0.5), leaning(b + s, sum.z), leaning(b + s, bricks.z * scratches.z)}},
      {"the cross product is at a right angle to both normals, so it lies in the wall",
       cross(bricks, scratches)},
  };
  return {
      changed(normals, normalize<double>),
      {"your normal is not a unit vector: divide it by its length, with normalize",
       leaning(b + s, 1)},
      normals,
  };
}

constexpr Place<Vec3d, Vec3d> scratched_places[] = {
    {"the slope 3/4 of the bricks and flat scratches: the normal of the bricks",
     {{-0.6, 0, 0.8}, {0, 0, 1}}},
    {"flat bricks: the normal of the scratches", {{0, 0, 1}, {0, 0.8, 0.6}}},
    {"a slope of 3/4 along x and one of 3/4 along y", {{-0.6, 0, 0.8}, {0, -0.6, 0.8}}},
    {"twice the slope 3/4 is the slope 3/2", {{-0.6, 0, 0.8}, {-0.6, 0, 0.8}}},
    {"slopes of 3/4 and -3/4: flat", {{-0.6, 0, 0.8}, {0.6, 0, 0.8}}},
    {"slopes of -4/3 and 3/4", {{0.8, 0, 0.6}, {-0.6, 0, 0.8}}},
    {"the normals (2, 1, 2) / 3 and (-2, 3, 6) / 7",
     {{2 / 3., 1 / 3., 2 / 3.}, {-2 / 7., 3 / 7., 6 / 7.}}},
};

}  // namespace

ExercisesOfChapter all_exercises_of_chapter() {
  return {
      "11",
      {exercise(scratched, picture<Lesson>({}, 21),
                {right_normal, wrong_normals, scratched_places})},
      {{"A plane has the slope 1/4 everywhere. By how many degrees does its normal lean?",
        [] { return atan(0.25) / radian; },
        {"degrees", 0.003},
        "The normal is (-1/4, 0, 1). Which angle is between it and (0, 0, 1)?",
        {{14.48, "the slope is the tangent of the angle, not the sine"},
         {75.96, "this is the angle to the plane: how far does the normal lean from straight up"}}},
       {"No byte means 0. By how many degrees does the flat color (128, 128, 255) lean?",
        [] {
          const auto [x, y, z] = normal_of_color(Rgb{128 / 255., 128 / 255., 1});
          return atan2(std::hypot(x, y), z) / radian;
        },
        {"degrees", 0.02},
        "Which numbers do 128, 128 and 255 mean? Two of them should be 0.",
        {{0.2247, "this is the lean in one direction: x and y lean both"}}}},
  };
}

}  // namespace texmap::check
