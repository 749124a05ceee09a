// The exercises of chapter 11. The lesson's Bumps is here a struct that calls the student's
// function: with heights, or with a normal map that it makes of them.
#include <cmath>
#include <numbers>

#include "11_bump_and_normal_maps/sheets.hpp"
#include "engine/app/bump_options.hpp"
#include "exercises.hpp"
#include "texture/bump.hpp"
#include "texture/normal_map.hpp"

namespace texmap::check {

static Hook<Vec3<double>(double, double, double, double)> bump_normal;
static Hook<Vec3<double>(int, int, int)> normal_of_texel;
static Hook<Vec3<double>(Vec3<double>, Vec3<double>, double)> bitangent_of;

}  // namespace texmap::check

namespace texmap::chapter_11 {

/// Members as in texmap::Bumps, in the order in which the lesson names them.
template <class Height>
struct Bumps {
  Height height;
  double relief = 1;
  BumpForm form = BumpForm::exact;
  SlopeFrom slopes = SlopeFrom::duals;
  double step = 1e-3;

  Vec3<double> operator()(const Hit<double>& hit, double curvature) const {
    const Vec3<double>& n = hit.normal;
    const Vec3<double> east = normalize(Vec3<double>{n.z, 0, -n.x});
    const Vec3<double> north = cross(n, east);
    const auto sum = [&](const Vec3<double>& tangent, const Vec3<double>& bitangent,
                         const Vec3<double>& parts) {
      return tangent * parts.x + bitangent * parts.y + n * parts.z;
    };
    const auto height_at = [&](const Vec3<double>& offset) {
      return relief * height(moved(hit, offset, curvature)).r;
    };
    const double here = height_at({}), right = height_at(east * step), up = height_at(north * step);
    if (check::bump_normal)
      return sum(east, north, check::bump_normal.yours(here, right, up, step));

    const Slope<double> slope{here, (right - here) / step, (up - here) / step};
    const Vec3<double> raised = raised_normal(n, {east, north}, slope, curvature, form);
    // The right half of the globe has a mirrored copy of the map: there u grows westward.
    const double sign = check::bitangent_of && n.x > 0 ? -1 : 1;
    const Vec3<double> t = east * sign;
    const Rgb8 texel = color_of_normal({dot(raised, t), dot(raised, north), dot(raised, n)});
    const Vec3<double> parts =
        check::normal_of_texel
            ? check::normal_of_texel.yours(texel.r, texel.g, texel.b)
            : normal_of_color(Color<double>{texel.r / 255.0, texel.g / 255.0, texel.b / 255.0});
    const Vec3<double> b = check::bitangent_of ? check::bitangent_of.yours(n, t, sign) : north;
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
inline void show_bumps(const Lesson&, Session&) {}

}  // namespace texmap::chapter_11

#include "11_bump_and_normal_maps/lesson.hpp"

namespace texmap::check {
namespace {

using Vector = Vec3<double>;

Image globe() {
  auto lesson = prepared<chapter_11::Lesson>();
  lesson.stage.camera.fov_y_degrees = 21;
  return picture_of(lesson);
}

Exercise normal_of_a_bump() {
  const auto slopes = [](double here, double right, double up, double step) {
    return Vector{(right - here) / step, (up - here) / step, 1};
  };
  Law<Vector(double, double, double, double)> law{
      .right =
          [](double here, double right, double up, double step) {
            const Slope<double> slope{here, (right - here) / step, (up - here) / step};
            return raised_normal(Vector{0, 0, 1}, {{1, 0, 0}, {0, 1, 0}}, slope, 0.0,
                                 BumpForm::exact);
          },
      .places = {{"where the heights are equal, the normal is (0, 0, 1)", {2, 2, 2, 0.5}},
                 {"the slope 1 to the right: the normal leans to the left by 45 degrees",
                  {0, 1, 0, 1}},
                 {"the slope 1 upward: the normal leans down by 45 degrees", {0, 0, 1, 1}},
                 {"a height of 0.01 on a step of 0.04 is the slope 1/4", {0, 0.01, 0, 0.04}},
                 {"the slope -3/4 to the right: the normal leans to the right", {0.3, 0, 0.3, 0.4}},
                 {"slopes to both sides, on a hill", {1, 1.2, 0.7, 0.1}},
                 {"the normal has the length 1, also on a steep slope", {0, 5, 3, 0.1}}},
      .mistakes = {}};
  const auto wrong = [&](const char* word, const std::function<Vector(Vector slopes)>& function) {
    law.mistakes.push_back({word, [=](double here, double right, double up, double step) {
                              return function(slopes(here, right, up, step));
                            }});
  };
  wrong("your normal leans uphill: bumps look like dents. Subtract the gradient", [](Vector s) {
    return normalize(Vector{s.x, s.y, 1});
  });
  wrong("your normal is not a unit vector: the light on slopes is too bright", [](Vector s) {
    return Vector{-s.x, -s.y, 1};
  });
  wrong("your normal leans uphill, and it is not a unit vector", [](Vector s) {
    return Vector{s.x, s.y, 1};
  });
  wrong("your normal points inward, away from the light: its third number must be 1, not -1",
        [](Vector s) {
          return normalize(Vector{-s.x, -s.y, -1});
        });
  wrong("your normal points inward: all three numbers have the other sign", [](Vector s) {
    return normalize(Vector{s.x, s.y, -1});
  });
  wrong("the slope upward has the wrong sign: the light comes from the wrong side along y",
        [](Vector s) {
          return normalize(Vector{-s.x, s.y, 1});
        });
  wrong("the slope to the right belongs to x, the slope upward to y: yours are exchanged",
        [](Vector s) {
          return normalize(Vector{-s.y, -s.x, 1});
        });
  const auto differences = [&](const char* word, double sign) {
    law.mistakes.push_back(
        {word, [=](double here, double right, double up, double) {
           return normalize(Vector{sign * (right - here), sign * (up - here), 1});
         }});
  };
  differences("a slope is the difference divided by the step: your bumps are nearly flat", -1);
  differences("a slope is the difference divided by the step; and subtract the gradient", 1);
  return exercise("11.1", "Vec3 bump_normal(double here, double right, double up, double step)",
                  std::move(law), bump_normal, globe);
}

Exercise normal_from_three_bytes() {
  const auto of_channels = [](const std::function<double(int)>& channel) {
    return [=](int red, int green, int blue) {
      return Vector{channel(red), channel(green), channel(blue)};
    };
  };
  const auto right = [](int red, int green, int blue) {
    return normal_of_color(Color<double>{red / 255.0, green / 255.0, blue / 255.0});
  };
  Law<Vector(int, int, int)> law{
      .right = right,
      .places = {{"red 255 means x = 1", {255, 128, 128}},
                 {"red 0 means x = -1", {0, 128, 128}},
                 {"green 255 means y = 1: the file is green up", {128, 255, 128}},
                 {"the flat color (128, 128, 255) means z = 1, and x and y of 1/255",
                  {128, 128, 255}},
                 {"(128, 218, 218) leans by 45 degrees toward B", {128, 218, 218}},
                 {"(51, 102, 204) means (-0.6, -0.2, 0.6)", {51, 102, 204}}},
      .mistakes = {
          {"a channel means 2c - 1: your numbers run from 0 to 1 and never point left or down",
           of_channels([](int byte) { return byte / 255.0; })},
          {"red / 255 divides whole numbers, and the rest is lost: write 255.0",
           of_channels([](int byte) { return 2 * (byte / 255) - 1; })},
          {"x comes from red and z from blue: yours are exchanged (BGR in place of RGB)",
           [=](int red, int green, int blue) { return right(blue, green, red); }},
          {"green points down in your function: bumps look like dents along v",
           [=](int red, int green, int blue) { return right(red, 255 - green, blue); }},
          {"a channel is the byte / 255, not / 256: 255 must mean exactly 1",
           of_channels([](int byte) { return byte / 128.0 - 1; })},
          {"the middle is 127.5, between two bytes; you begin at 128, and 0 does not mean -1",
           of_channels([](int byte) { return (byte - 128) / 127.0; })},
          {"the numbers are right, but the lesson makes their sum a unit vector: return them as "
           "they are",
           [=](int red, int green, int blue) { return normalize(right(red, green, blue)); }}}};
  return exercise("11.2", "Vec3 normal_of_texel(int red, int green, int blue)", std::move(law),
                  normal_of_texel, globe);
}

Exercise bitangent_of_a_copy() {
  using Signature = Vector(Vector, Vector, double);
  Law<Signature> law{
      .right =
          [](Vector n, Vector t, double sign) {
            return tangents(TangentRule::crossed, n, {t, {}}).bitangent * sign;
          },
      .places = {{"n = (0, 0, 1), T = (1, 0, 0): B is (0, 1, 0)",
                  {Vector{0, 0, 1}, Vector{1, 0, 0}, 1}},
                 {"on a mirrored copy T is (-1, 0, 0) and the sign -1, and B is still (0, 1, 0)",
                  {Vector{0, 0, 1}, Vector{-1, 0, 0}, -1}},
                 {"n = (1, 0, 0), T = (0, 0, -1): B is (0, 1, 0)",
                  {Vector{1, 0, 0}, Vector{0, 0, -1}, 1}},
                 {"north of the equator, n = (0, 0.6, 0.8), T = (1, 0, 0): B leans back",
                  {Vector{0, 0.6, 0.8}, Vector{1, 0, 0}, 1}},
                 {"the same on a mirrored copy", {Vector{0, 0.6, 0.8}, Vector{-1, 0, 0}, -1}},
                 {"where the picture is turned by a quarter, T = (0, 1, 0): B is (-1, 0, 0)",
                  {Vector{0, 0, 1}, Vector{0, 1, 0}, 1}}},
      .mistakes = {{"the sign is not used: on the mirrored copy bumps look like dents along v",
                    [](Vector n, Vector t, double) { return cross(n, t); }},
                   {"the order matters: n x T, not T x n. Everywhere bumps look like dents along v",
                    [](Vector n, Vector t, double sign) { return cross(t, n) * sign; }},
                   {"the order is n x T, and the sign is not used: only the mirrored copy looks "
                    "right",
                    [](Vector n, Vector t, double) { return cross(t, n); }},
                   {"+y is not along the surface where n leans up or down, and v need not grow "
                    "that way",
                    [](Vector, Vector, double) {
                      return Vector{0, 1, 0};
                    }},
                   {"+y is not along the surface where n leans up or down, and v need not grow "
                    "that way",
                    [](Vector, Vector, double sign) {
                      return Vector{0, sign, 0};
                    }}}};
  return exercise("11.3", "Vec3 bitangent_of(Vec3 n, Vec3 t, double sign)", std::move(law),
                  bitangent_of, globe);
}

/// The angle between a vector and (0, 0, 1), in degrees.
double leans_by(const Vector& n) {
  return std::atan2(std::hypot(n.x, n.y), n.z) * 180 / std::numbers::pi;
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      .exercises = {normal_of_a_bump(), normal_from_three_bytes(), bitangent_of_a_copy()},
      .questions =
          {{"11.a",
            "A plane has the slope 1/4 everywhere. By how many degrees does its normal lean?",
            [] {
              return leans_by(raised_normal(Vector{0, 0, 1}, {{1, 0, 0}, {0, 1, 0}},
                                            Slope<double>{0, 0.25, 0}, 0.0, BumpForm::exact));
            },
            "degrees", 1e-3},
           {"11.b",
            "No byte means 0. By how many degrees does the flat color (128, 128, 255) lean?",
            [] {
              return leans_by(normal_of_color(Color<double>{128 / 255.0, 128 / 255.0, 1}));
            },
            "degrees", 0.02}},
  };
  return chapter;
}

}  // namespace texmap::check
