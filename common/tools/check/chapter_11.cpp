// The exercises of chapter 11. The lesson's Bumps is here a struct that calls the student's
// function: with heights, or with a normal map that it makes of them.
#include "11_bump_and_normal_maps/sheets.hpp"
#include "engine/run/bump_options.hpp"
#include "exercises.hpp"
#include "math/srgb.hpp"
#include "texture/bump.hpp"
#include "texture/normal_map.hpp"

namespace texmap::chapter_11 {

static std::function<Vec3d(double, double, double, double)> bump_normal;
static std::function<Vec3d(int, int, int)> normal_of_texel;
static std::function<Vec3d(Vec3d, Vec3d, double)> bitangent_of;

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
    const auto sum = [&](const Vec3d& tangent, const Vec3d& bitangent, const Vec3d& parts) {
      return tangent * parts.x + bitangent * parts.y + n * parts.z;
    };
    const auto height_at = [&](const Vec3d& offset) {
      return relief * height(moved(hit, offset, curvature)).r;
    };
    const double here = height_at({}), right = height_at(east * step), up = height_at(north * step);
    if (bump_normal) return sum(east, north, bump_normal(here, right, up, step));

    const Slope<double> slope{here, (right - here) / step, (up - here) / step};
    const Vec3d raised = raised_normal(n, {east, north}, slope, curvature, form);
    // The right half of the globe has a mirrored copy of the map: there u grows westward.
    const double sign = bitangent_of && n.x > 0 ? -1 : 1;
    const Vec3d t = east * sign;
    const Rgb8 texel = color_of_normal({dot(raised, t), dot(raised, north), dot(raised, n)});
    const Vec3d parts =
        normal_of_texel ? normal_of_texel(texel.r, texel.g, texel.b)
                        : normal_of_color(Rgb{texel.r / 255.0, texel.g / 255.0, texel.b / 255.0});
    const Vec3d b = bitangent_of ? bitangent_of(n, t, sign) : north;
    return normalize(sum(t, b, parts));
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

Image globe() { return picture_of(prepared<Lesson>(), 21); }

/// Both slopes by the same wrong formula.
Slips<Vec3d> wrong_slopes(double h, double right, double up, double step) {
  const double dx = right - h, dy = up - h;
  const double x = dx / step, y = dy / step;
  return {
      {"a slope is the difference of two heights, divided by the step",
       {{"here is missing", {{right / step, up / step, 1}, {right, up, 1}}},
        {"/ comes before -, write (right - here) / step",
         {{right - h / step, up - h / step, 1}, {right / step - h, up / step - h, 1}}},
        {"you multiply, or divide the step by it", {{dx * step, dy * step, 1}, {1 / x, 1 / y, 1}}},
        {"here and right are one step apart, not two", {x / 2, y / 2, 1}},
        {"here only that to the right is divided", {x, dy, 1}},
        {"it has a sign", {abs(x), abs(y), 1}},
        {"this is the angle of the slope", {atan(x), atan(y), 1}},
        {"one of the two is missing", {{x, 0, 1}, {0, y, 1}}},
        {"they are exchanged, or both are the one to the right", {{y, x, 1}, {x, x, 1}}},
        {"you compare up with right", {{x, (up - right) / step, 1}, {(right - up) / step, y, 1}}}}},
      {"the third number is 1, that of the flat surface",
       {{x, y, 0}, {x, y, step}, {x, y, 1 + h}, {x, y, h}}},
  };
}

Slips<Vec3d> wrong_normals(double here, double right, double up, double step) {
  const double dx = right - here, dy = up - here;
  const double x = dx / step, y = dy / step;
  const auto unit = [](double a, double b, double c) { return normalize(Vec3d{a, b, c}); };
  /// As it is, and of length 1.
  const auto any_length = [](const Vec3d& n) { return std::vector{normalize(n), n}; };
  Slips<Vec3d> wrong = {
      {"your normal leans uphill: bumps look like dents. Subtract the gradient", unit(x, y, 1)},
      {"your normal is not a unit vector: divide it by its length, with normalize",
       {{-x, -y, 1}, {-dx, -dy, step}, {-dx * step, -dy * step, step * step}}},
      {"your normal leans uphill, and it is not a unit vector", {{x, y, 1}, {dx, dy, step}}},
      {"the order is right x up; and make the length 1", {dx * step, dy * step, -step * step}},
      {"the slope upward has the wrong sign: light from the wrong side", any_length({-x, y, 1})},
      {"the slope to the right has the wrong sign: light from the wrong side",
       any_length({x, -y, 1})},
      {"a slope is the difference divided by the step",
       {{"your bumps are nearly flat", unit(-dx, -dy, 1)},
        {"your bumps are nearly flat, and the length is not 1", {-dx, -dy, 1}},
        {"your bumps are nearly flat, and look like dents", any_length({dx, dy, 1})}}},
      {"divide by the length, not by its square", Vec3d{-x, -y, 1} * (1 / (x * x + y * y + 1))},
      {"your normal points inward, away from the light: its third number must be above 0",
       {unit(-x, -y, -1), unit(x, y, -1), {x, y, -1}}},
      {"do not choose z for the length 1: on a steep slope it has no root. Take 1, normalize",
       any_length({-x, -y, sqrt(1 - x * x - y * y)})},
      {"the normal is at a right angle to the surface", {unit(1, 0, x), unit(1, 1, x + y)}},
      {"z is out of the surface here, not y: return the 1 as the third number",
       {unit(-x, 1, -y), unit(x, 1, y), Vec3d{-x, 1, -y}}},
  };
  // Downhill and uphill, of length 1 and not.
  const Slips<Vec3d> slopes = wrong_slopes(here, right, up, step);
  for (const double sign : {-1, 1}) {
    const auto leaning = [=](const Vec3d& s) { return Vec3d{sign * s.x, sign * s.y, s.z}; };
    wrong += changed(slopes, [=](const Vec3d& s) { return normalize(leaning(s)); });
    wrong += changed(slopes, leaning);
  }
  return wrong;
}

constexpr Place<double, double, double, double> bump_normal_places[] = {
    {"where the heights are equal, the normal is (0, 0, 1)", {2, 2, 2, 0.5}},
    {"the slope 1 to the right: the normal leans to the left by 45 degrees", {0, 1, 0, 1}},
    {"the slope 1 upward: the normal leans down by 45 degrees", {0, 0, 1, 1}},
    {"a height of 0.01 on a step of 0.04 is the slope 1/4", {0, 0.01, 0, 0.04}},
    {"the slope -3/4 to the right: the normal leans to the right", {0.3, 0, 0.3, 0.4}},
    {"slopes to both sides, on a hill", {1, 1.2, 0.7, 0.1}},
    {"the normal has the length 1, also on a steep slope", {0, 5, 3, 0.1}},
};

/// The three numbers from -1 to 1 that a texel means.
Vec3d numbers_of(int red, int green, int blue) {
  return normal_of_color(Rgb{red / 255.0, green / 255.0, blue / 255.0});
}

constexpr auto middle =
    "the middle is 127.5, between two bytes: subtract 127.5, then divide by 127.5";

/// A channel's number from -1 to 1 as many compute it.
Slips<double> wrong_channels(int byte) {
  const double c = byte / 255.0, n = byte / 127.5 - 1;
  const auto doubles = [](std::vector<int> all) {
    return std::vector<double>(all.begin(), all.end());
  };
  return {
      {"a channel c means 2c - 1",
       {{"your numbers do not run from -1 to 1", {c, c - 1, 2 * c - 0.5, 2 * c + 1}},
        {"yours is 1 - 2c", -n},
        {"this goes back, from a number to its channel", (c + 1) / 2}}},
      {"write 2 * (red / 255.0) - 1",
       {{"you divide whole numbers, and the rest is lost",
         doubles({2 * (byte / 255) - 1, 2 * byte / 255 - 1, byte / 255, byte / 128 - 1,
                  byte / 127 - 1, (byte - 128) / 128, (byte - 128) / 127, (byte - 127) / 128})},
        {"/ comes before -", {2 * byte - 1 / 255.0, (2 * byte - 1) / 255.0}}}},
      {middle, {(byte - 127) / 128.0, (byte - 127) / 127.5, byte / 127.0 - 1}},
      {"bytes below 128 mean numbers below 0: keep their sign", {max(n, 0.0), abs(n)}},
      {"a normal map stores numbers, not colors: leave srgb_decode out", 2 * srgb_decode(c) - 1},
  };
}

/// The same, where a unit vector of these has the direction of another mistake's or the right one.
Slips<double> wrong_scales(int byte) {
  const double c = byte / 255.0;
  return {
      {"0 must mean exactly -1 and 255 exactly 1: c is red / 255.0",
       {(byte + 0.5) / 128 - 1, byte / 128.0 - 1}},
      {"the middle is 127.5, between two bytes; you begin at 128, and 0 does not mean -1",
       {(byte - 128) / 127.0, (byte - 128) / 127.5}},
      {"yours do not run from -1 to 1: a channel c means 2c - 1", {2 * c, c - 0.5, 2 * (c - 1)}},
      {"these are bytes: divide by 255.0, so that c is 0 to 1", {1.0 * byte, 2.0 * byte - 1}},
      {"subtract the middle, then divide by 127.5: 255 means 1", {byte - 127.5, byte - 128.0}},
      {middle, (byte - 127.5) / 127},
  };
}

/// The table of a channel for all three.
Slips<Vec3d> of_texel(Slips<double> (*table)(int), int red, int green, int blue) {
  const auto vector = [](double r, double g, double b) { return Vec3d{r, g, b}; };
  return combined(vector, table(red), table(green), table(blue));
}

Slips<Vec3d> wrong_texels(int red, int green, int blue) {
  const Vec3d right = numbers_of(red, green, blue);
  const auto [x, y, z] = right;
  Slips<Vec3d> channels = of_texel(wrong_channels, red, green, blue);
  channels += {
      {"green points down in your function: bumps look like dents along v", {x, -y, z}},
      {"red points left in your function: bumps look like dents along u", {-x, y, z}},
      {"x comes from red, y from green, z from blue: yours are exchanged or copied",
       {{z, y, x}, {x, z, y}, {y, x, z}, {x, x, x}, {x, y, y}, {x, x, z}}},
      {"blue means 2c - 1, too: 128 is about 0, 255 is 1", {{x, y, (z + 1) / 2}, {x, y, z + 1}}},
      {"z is in the file: take 2c - 1 of blue, do not compute it from x and y",
       {{x, y, sqrt(1 - x * x - y * y)}, {x, y, sqrt(max(0.0, 1 - x * x - y * y))}, {x, y, 1}}},
      {"blue bytes below 128 mean numbers below 0: do not limit z to 0", {x, y, max(z, 0.0)}},
  };
  return {
      {"return the numbers as they are: the lesson makes the sum a unit vector", normalize(right)},
      {"the middle is 127.5, not 128; and return the numbers as they are, not a unit vector",
       normalize(Vec3d{red - 128.0, green - 128.0, blue - 128.0})},
      channels,
      // Those who make another mistake often make a unit vector, too.
      changed(channels, normalize<double>),
      of_texel(wrong_scales, red, green, blue),
  };
}

constexpr Place<int, int, int> normal_of_texel_places[] = {
    {"red 255 means x = 1", {255, 128, 128}},
    {"red 0 means x = -1", {0, 128, 128}},
    {"green 255 means y = 1: the file is green up", {128, 255, 128}},
    {"the flat color (128, 128, 255) means z = 1, and x and y of 1/255", {128, 128, 255}},
    {"(128, 218, 218) leans by 45 degrees toward B", {128, 218, 218}},
    {"(51, 102, 204) means (-0.6, -0.2, 0.6)", {51, 102, 204}},
    {"blue 51 means z = -0.6", {204, 102, 51}},
};

Slips<Vec3d> wrong_bitangents(Vec3d n, Vec3d t, double sign) {
  const Vec3d b = cross(n, t), up{0, 1, 0}, out{0, 0, 1};
  Slips<Vec3d> wrong = {
      {"the sign is not used: on the mirrored copy bumps look like dents along v", b},
      {"the order matters: n x T, not T x n. Everywhere bumps look like dents along v", -b * sign},
      {"the order is n x T, and the sign is not used: only the mirrored copy looks right", -b},
      {"on the mirrored copy your B is (0, 0, 0): it is n x T times -1 there", b * max(sign, 0.0)},
      {"the sign turns all three numbers of n x T around: yours turns one alone",
       {{b.x * sign, b.y, b.z}, {b.x, b.y * sign, b.z}, {b.x, b.y, b.z * sign}}},
      {"v need not grow upward: leave B as it is where its y is below 0, and use the sign",
       {b.y < 0 ? -b : b, Vec3d{b.x, abs(b.y), b.z}}},
      {"whether a copy is mirrored is in the sign: T alone does not say it", t.x < 0 ? -b : b},
  };
  const Slips<Vec3d> vectors = {
      {"take cross(n, T)",
       {{"+y is not along the surface, and v need not grow that way", up},
        {"sums of n and T lie in their plane, not at a right angle to both", {n + t, n - t, t - n}},
        {"this is T or n, and B is at a right angle to both", {t, n}},
        {"the picture's T counts, not +y", {cross(up, n), cross(n, up), cross(n, cross(up, n))}},
        {"B is at a right angle to n, too, without an axis",
         {cross(up, t), cross(t, up), cross(out, t), cross(t, out)}},
        {"your B has no direction, all its numbers are 0", {0, 0, 0}},
        {"this is no cross product",
         {{n.x * t.x, n.y * t.y, n.z * t.z},
          {n.y * t.z, n.z * t.x, n.x * t.y},
          {n.y * t.z + n.z * t.y, n.z * t.x + n.x * t.z, n.x * t.y + n.y * t.x}}}}},
      {"the middle of your cross product has the wrong sign: n.z T.x - n.x T.z", {b.x, -b.y, b.z}},
  };
  // Without the sign and with it, as they are and of length 1.
  for (const double factor : {sign, 1.0}) {
    wrong += changed(vectors, [=](const Vec3d& v) { return v * factor; });
    wrong += changed(vectors, [=](const Vec3d& v) { return normalize(v * factor); });
  }
  return wrong;
}

constexpr Place<Vec3d, Vec3d, double> bitangent_of_places[] = {
    {"n = (0, 0, 1), T = (1, 0, 0): B is (0, 1, 0)", {{0, 0, 1}, {1, 0, 0}, 1}},
    {"on a mirrored copy T is (-1, 0, 0), the sign -1, B (0, 1, 0)", {{0, 0, 1}, {-1, 0, 0}, -1}},
    {"n = (1, 0, 0), T = (0, 0, -1): B is (0, 1, 0)", {{1, 0, 0}, {0, 0, -1}, 1}},
    {"on the back, n = (0, 0, -1), T = (-1, 0, 0): B is (0, 1, 0)", {{0, 0, -1}, {-1, 0, 0}, 1}},
    {"to the north, n = (0, 0.6, 0.8), T = (1, 0, 0): B leans back", {{0, 0.6, 0.8}, {1, 0, 0}, 1}},
    {"the same on a mirrored copy", {{0, 0.6, 0.8}, {-1, 0, 0}, -1}},
    {"with the picture turned by a quarter, T = (0, 1, 0): B is -x", {{0, 0, 1}, {0, 1, 0}, 1}},
    {"upside down, T = (-1, 0, 0) and the sign is 1: B is (0, -1, 0)", {{0, 0, 1}, {-1, 0, 0}, 1}},
    {"n = (2, 1, 2) / 3, T = (-2, 2, 1) / 3, mirrored: B is (1, 2, -2) / 3",
     {{2 / 3., 1 / 3., 2 / 3.}, {-2 / 3., 2 / 3., 1 / 3.}, -1}},
};

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      "11",
      {exercise(bump_normal, globe,
                {[](double here, double beside, double above, double step) {
                   const Slope<double> slope{here, (beside - here) / step, (above - here) / step};
                   return raised_normal(Vec3d{0, 0, 1}, {{1, 0, 0}, {0, 1, 0}}, slope, 0.0,
                                        BumpForm::exact);
                 },
                 wrong_normals, bump_normal_places}),
       exercise(normal_of_texel, globe, {numbers_of, wrong_texels, normal_of_texel_places}),
       exercise(bitangent_of, globe,
                {[](Vec3d n, Vec3d t, double sign) {
                   return tangents(TangentRule::crossed, n, {t, {}}).bitangent * sign;
                 },
                 wrong_bitangents, bitangent_of_places})},
      {{"A plane has the slope 1/4 everywhere. By how many degrees does its normal lean?",
        [] { return atan(0.25) / radian; },
        {"degrees", 0.003},
        "The normal is (-1/4, 0, 1). Which angle is between it and (0, 0, 1)?",
        {{14.48, "the slope is the tangent of the angle, not the sine"},
         {75.96, "this is the angle to the plane: how far does the normal lean from straight up"}}},
       {"No byte means 0. By how many degrees does the flat color (128, 128, 255) lean?",
        [] {
          const auto [x, y, z] = numbers_of(128, 128, 255);
          return atan2(std::hypot(x, y), z) / radian;
        },
        {"degrees", 0.02},
        "Which numbers do 128, 128 and 255 mean? Two of them should be 0.",
        {{0.2247, "this is the lean in one direction: x and y lean both"}}}},
  };
  return chapter;
}

}  // namespace texmap::check
