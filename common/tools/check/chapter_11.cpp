// The exercises of chapter 11. The lesson's Bumps is here a struct that calls the student's
// function: with heights, or with a normal map that it makes of them.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "11_bump_and_normal_maps/sheets.hpp"
#include "engine/app/bump_options.hpp"
#include "exercises.hpp"
#include "math/srgb.hpp"
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
inline void show_bumps(Lesson&, Session&) {}

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

using NormalOfBump = Vector(double, double, double, double);

/// What the function of 11.1 gets.
struct Heights {
  double here, right, up, step;

  [[nodiscard]] Vector slopes() const { return {(right - here) / step, (up - here) / step, 1}; }
};

/// Slopes as many compute them, each in a normal that leans downhill and in one that leans uphill,
/// of length 1 and not.
void add_wrong_slopes(std::vector<Mistake<NormalOfBump>>& mistakes) {
  const auto wrong = [&](const char* word, auto slopes) {
    for (const double sign : {-1, 1}) {
      for (const bool unit : {true, false}) {
        mistakes.push_back({word, [=](double here, double right, double up, double step) {
                              const Vector s = slopes(Heights{here, right, up, step});
                              const Vector n{sign * s.x, sign * s.y, s.z};
                              return unit ? normalize(n) : n;
                            }});
      }
    }
  };
  const auto wrong_slope = [&](const char* word, double (*slope)(double other, const Heights&)) {
    wrong(word, [=](const Heights& h) { return Vector{slope(h.right, h), slope(h.up, h), 1}; });
  };
  const char* missing =
      "here is missing: a slope is the difference of two heights, divided by the step";
  wrong_slope(missing, [](double other, const Heights& h) { return other / h.step; });
  wrong_slope(missing, [](double other, const Heights&) { return other; });
  const char* brackets = "/ comes before -: write (right - here) / step, and the same with up";
  wrong_slope(brackets, [](double other, const Heights& h) { return other - h.here / h.step; });
  wrong_slope(brackets, [](double other, const Heights& h) { return other / h.step - h.here; });
  wrong_slope("divide the difference by the step: you multiply them",
              [](double other, const Heights& h) { return (other - h.here) * h.step; });
  wrong_slope("divide the difference by the step, not the step by the difference",
              [](double other, const Heights& h) { return h.step / (other - h.here); });
  wrong_slope("here and right are one step apart, not two: your slopes are half of the right ones",
              [](double other, const Heights& h) { return (other - h.here) / (2 * h.step); });
  wrong_slope("a slope has a sign: without it the normal leans to the same side everywhere",
              [](double other, const Heights& h) { return std::abs(other - h.here) / h.step; });
  wrong_slope("this is the angle of the slope: the normal needs the slope itself",
              [](double other, const Heights& h) { return std::atan((other - h.here) / h.step); });
  wrong("the slope upward is up - here: yours compares up with right", [](const Heights& h) {
    return Vector{h.slopes().x, (h.up - h.right) / h.step, 1};
  });
  wrong("the slope to the right is right - here: yours compares right with up",
        [](const Heights& h) {
          return Vector{(h.right - h.up) / h.step, h.slopes().y, 1};
        });
  wrong("both slopes are the one to the right: y needs up - here", [](const Heights& h) {
    return Vector{h.slopes().x, h.slopes().x, 1};
  });
  wrong("the slope upward is missing: y is its negative", [](const Heights& h) {
    return Vector{h.slopes().x, 0, 1};
  });
  wrong("the slope to the right is missing: x is its negative", [](const Heights& h) {
    return Vector{0, h.slopes().y, 1};
  });
  wrong("a slope is the difference divided by the step: here only that to the right is divided",
        [](const Heights& h) {
          return Vector{h.slopes().x, h.up - h.here, 1};
        });
  wrong("the slope to the right belongs to x, the slope upward to y: yours are exchanged",
        [](const Heights& h) {
          return Vector{h.slopes().y, h.slopes().x, 1};
        });
  wrong("the third number is missing: the flat surface's own normal is (0, 0, 1)",
        [](const Heights& h) {
          return Vector{h.slopes().x, h.slopes().y, 0};
        });
  wrong("the third number is 1 once the differences are divided by the step, not the step again",
        [](const Heights& h) {
          return Vector{h.slopes().x, h.slopes().y, h.step};
        });
  wrong("the third number is 1: the surface is flat, and 1 + h / R is for a ball",
        [](const Heights& h) {
          return Vector{h.slopes().x, h.slopes().y, 1 + h.here};
        });
  wrong("the third number is 1: how high the surface is does not count, only its slopes",
        [](const Heights& h) {
          return Vector{h.slopes().x, h.slopes().y, h.here};
        });
}

/// Normals of the right slopes as many compute them: not of length 1, or with another z.
void add_wrong_forms(std::vector<Mistake<NormalOfBump>>& mistakes) {
  const auto wrong = [&](const char* word, Vector (*normal)(const Vector& s)) {
    mistakes.push_back({word, [=](double here, double right, double up, double step) {
                          return normal(Heights{here, right, up, step}.slopes());
                        }});
  };
  wrong("divide by the length of the vector, not by its square", [](const Vector& s) {
    return Vector{-s.x, -s.y, 1} * (1 / dot(s, s));
  });
  wrong("your normal points inward, away from the light: its third number must be 1, not -1",
        [](const Vector& s) {
          return normalize(Vector{-s.x, -s.y, -1});
        });
  const char* inward = "your normal points inward: all three numbers have the other sign";
  wrong(inward, [](const Vector& s) { return normalize(Vector{s.x, s.y, -1}); });
  wrong(inward, [](const Vector& s) { return Vector{s.x, s.y, -1}; });
  const char* pythagoras =
      "do not choose z for the length 1: steeper than 45 degrees it has no root. Take 1, normalize";
  wrong(pythagoras, [](const Vector& s) {
    return Vector{-s.x, -s.y, std::sqrt(1 - s.x * s.x - s.y * s.y)};
  });
  wrong(pythagoras, [](const Vector& s) {
    return normalize(Vector{-s.x, -s.y, std::sqrt(1 - s.x * s.x - s.y * s.y)});
  });
  const char* along = "your vector lies along the surface: the normal is at a right angle to it";
  wrong(along, [](const Vector& s) { return normalize(Vector{1, 0, s.x}); });
  wrong(along, [](const Vector& s) { return normalize(Vector{1, 1, s.x + s.y}); });
  const char* y_up = "z is out of the surface here, not y: return the 1 as the third number";
  wrong(y_up, [](const Vector& s) { return normalize(Vector{-s.x, 1, -s.y}); });
  wrong(y_up, [](const Vector& s) { return normalize(Vector{s.x, 1, s.y}); });
  wrong(y_up, [](const Vector& s) { return Vector{-s.x, 1, -s.y}; });
}

/// Normals as many compute them.
std::vector<Mistake<NormalOfBump>> wrong_normals() {
  std::vector<Mistake<NormalOfBump>> mistakes;
  /// From the right slopes, with the third number 1.
  const auto wrong = [&](const char* word, Vector (*normal)(const Vector& s)) {
    mistakes.push_back({word, [=](double here, double right, double up, double step) {
                          return normal(Heights{here, right, up, step}.slopes());
                        }});
  };
  /// From the differences as they are.
  const auto undivided = [&](const char* word, Vector (*normal)(double x, double y, double step)) {
    mistakes.push_back({word, [=](double here, double right, double up, double step) {
                          return normal(right - here, up - here, step);
                        }});
  };
  wrong("your normal leans uphill: bumps look like dents. Subtract the gradient",
        [](const Vector& s) {
          return normalize(Vector{s.x, s.y, 1});
        });
  wrong("your normal is not a unit vector: the light on slopes is too bright", [](const Vector& s) {
    return Vector{-s.x, -s.y, 1};
  });
  const char* both = "your normal leans uphill, and it is not a unit vector";
  wrong(both, [](const Vector& s) { return s; });
  undivided(both, [](double x, double y, double step) { return Vector{x, y, step}; });
  const char* length =
      "your normal has the right direction; divide it by its length, with normalize";
  undivided(length, [](double x, double y, double step) { return Vector{-x, -y, step}; });
  undivided(length, [](double x, double y, double step) {
    return Vector{-x * step, -y * step, step * step};
  });
  undivided("the order matters: right x up, not up x right; and make the length 1",
            [](double x, double y, double step) {
              return Vector{x * step, y * step, -step * step};
            });
  const char* along_y =
      "the slope upward has the wrong sign: the light comes from the wrong side along y";
  wrong(along_y, [](const Vector& s) { return normalize(Vector{-s.x, s.y, 1}); });
  wrong(along_y, [](const Vector& s) { return Vector{-s.x, s.y, 1}; });
  const char* along_x =
      "the slope to the right has the wrong sign: the light comes from the wrong side along x";
  wrong(along_x, [](const Vector& s) { return normalize(Vector{s.x, -s.y, 1}); });
  wrong(along_x, [](const Vector& s) { return Vector{s.x, -s.y, 1}; });
  undivided("a slope is the difference divided by the step: your bumps are nearly flat",
            [](double x, double y, double) {
              return normalize(Vector{-x, -y, 1});
            });
  undivided("a slope is the difference divided by the step; and make the length 1, with normalize",
            [](double x, double y, double) {
              return Vector{-x, -y, 1};
            });
  const char* undivided_uphill =
      "a slope is the difference divided by the step; and subtract the gradient";
  undivided(undivided_uphill, [](double x, double y, double) {
    return normalize(Vector{x, y, 1});
  });
  undivided(undivided_uphill, [](double x, double y, double) { return Vector{x, y, 1}; });
  add_wrong_forms(mistakes);
  add_wrong_slopes(mistakes);
  return mistakes;
}

Exercise normal_of_a_bump() {
  Law<NormalOfBump> law{
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
      .mistakes = wrong_normals()};
  return exercise("11.1", "Vec3 bump_normal(double here, double right, double up, double step)",
                  std::move(law), bump_normal, globe);
}

using NormalOfTexel = Vector(int, int, int);

/// The three numbers from -1 to 1 that a texel means.
Vector numbers_of(int red, int green, int blue) {
  return normal_of_color(Color<double>{red / 255.0, green / 255.0, blue / 255.0});
}

/// Numbers from -1 to 1 as many compute them, the same in each channel.
void add_wrong_channels(std::vector<Mistake<NormalOfTexel>>& mistakes) {
  const auto wrong = [&](const char* word, auto channel) {
    const auto numbers = [=](int red, int green, int blue) -> Vector {
      return {1.0 * channel(red), 1.0 * channel(green), 1.0 * channel(blue)};
    };
    mistakes.push_back({word, numbers});
    mistakes.push_back(
        {word, [=](int red, int green, int blue) { return normalize(numbers(red, green, blue)); }});
  };
  wrong("a channel means 2c - 1: your numbers run from 0 to 1 and never point left or down",
        [](int byte) { return byte / 255.0; });
  const char* whole = "you divide whole numbers, and the rest is lost: write 2 * (red / 255.0) - 1";
  wrong(whole, [](int byte) { return 2 * (byte / 255) - 1; });
  wrong(whole, [](int byte) { return 2 * byte / 255 - 1; });
  wrong(whole, [](int byte) { return byte / 255; });
  wrong(whole, [](int byte) { return byte / 128 - 1; });
  wrong(whole, [](int byte) { return byte / 127 - 1; });
  wrong(whole, [](int byte) { return (byte - 128) / 128; });
  wrong(whole, [](int byte) { return (byte - 128) / 127; });
  wrong(whole, [](int byte) { return (byte - 127) / 128; });
  wrong("0 must mean exactly -1 and 255 exactly 1: write 2 * (red / 255.0) - 1",
        [](int byte) { return (byte + 0.5) / 128 - 1; });
  wrong("a channel is the byte / 255, not / 256: 255 must mean exactly 1",
        [](int byte) { return byte / 128.0 - 1; });
  const char* middle =
      "the middle is 127.5, between two bytes; you begin at 128, and 0 does not mean -1";
  wrong(middle, [](int byte) { return (byte - 128) / 127.0; });
  wrong(middle, [](int byte) { return (byte - 128) / 127.5; });
  const char* middle_127 =
      "the middle is 127.5, between two bytes: subtract 127.5, then divide by 127.5";
  wrong(middle_127, [](int byte) { return (byte - 127) / 128.0; });
  wrong(middle_127, [](int byte) { return (byte - 127) / 127.5; });
  wrong(middle_127, [](int byte) { return byte / 127.0 - 1; });
  wrong(middle_127, [](int byte) { return (byte - 127.5) / 127; });
  wrong("your numbers run from 0 to 2: subtract 1 from 2c",
        [](int byte) { return 2 * (byte / 255.0); });
  wrong("your numbers run from -1 to 0: double c, then subtract 1",
        [](int byte) { return byte / 255.0 - 1; });
  wrong("your numbers run from -1/2 to 1/2: it is 2c - 1",
        [](int byte) { return byte / 255.0 - 0.5; });
  wrong("your numbers run from -2 to 0: double c alone, then subtract 1",
        [](int byte) { return 2 * (byte / 255.0 - 1); });
  wrong("your numbers run from -1/2 to 3/2: subtract 1 from 2c, not 1/2",
        [](int byte) { return 2 * (byte / 255.0) - 0.5; });
  wrong("your numbers run from 1 to 3: subtract 1 from 2c, do not add it",
        [](int byte) { return 2 * (byte / 255.0) + 1; });
  wrong("the sign is wrong: it is 2c - 1, not 1 - 2c", [](int byte) { return 1 - byte / 127.5; });
  wrong("this goes back, from a number to its channel: the number is 2c - 1",
        [](int byte) { return (byte / 255.0 + 1) / 2; });
  const char* order =
      "/ comes before -, and divides what stands right before it: 2 * (red / 255.0) - 1";
  wrong(order, [](int byte) { return 2 * byte - 1 / 255.0; });
  wrong(order, [](int byte) { return (2 * byte - 1) / 255.0; });
  const char* bytes = "these are bytes: divide by 255.0 first, so that c runs from 0 to 1";
  wrong(bytes, [](int byte) { return 1.0 * byte; });
  wrong(bytes, [](int byte) { return 2.0 * byte - 1; });
  const char* undivided =
      "subtracting the middle is right; then divide by 127.5, so that 255 means 1";
  wrong(undivided, [](int byte) { return byte - 127.5; });
  wrong(undivided, [](int byte) { return byte - 128.0; });
  wrong("bytes below 128 mean numbers below 0: do not limit them to 0",
        [](int byte) { return std::max(byte / 127.5 - 1, 0.0); });
  wrong("bytes below 128 mean numbers below 0: keep their sign",
        [](int byte) { return std::abs(byte / 127.5 - 1); });
  wrong("a normal map stores numbers, not colors: leave srgb_decode out",
        [](int byte) { return 2 * srgb_decode(byte / 255.0) - 1; });
}

/// Normals of texels as many compute them.
std::vector<Mistake<NormalOfTexel>> wrong_texels() {
  std::vector<Mistake<NormalOfTexel>> mistakes;
  mistakes.push_back(
      {"the direction is right, but the lesson makes the sum a unit vector: return the numbers as "
       "they are",
       [](int red, int green, int blue) { return normalize(numbers_of(red, green, blue)); }});
  mistakes.push_back(
      {"the middle is 127.5, not 128; and return the numbers as they are, not a unit vector",
       [](int red, int green, int blue) {
         return normalize(Vector{red - 128.0, green - 128.0, blue - 128.0});
       }});
  add_wrong_channels(mistakes);
  /// With the numbers as they are, and as a unit vector.
  const auto wrong = [&](const char* word, Vector (*change)(const Vector& n)) {
    mistakes.push_back(
        {word, [=](int red, int green, int blue) { return change(numbers_of(red, green, blue)); }});
    mistakes.push_back({word, [=](int red, int green, int blue) {
                          return normalize(change(numbers_of(red, green, blue)));
                        }});
  };
  wrong("x comes from red and z from blue: yours are exchanged (BGR in place of RGB)",
        [](const Vector& n) {
          return Vector{n.z, n.y, n.x};
        });
  wrong("green points down in your function: bumps look like dents along v", [](const Vector& n) {
    return Vector{n.x, -n.y, n.z};
  });
  wrong("red points left in your function: bumps look like dents along u", [](const Vector& n) {
    return Vector{-n.x, n.y, n.z};
  });
  wrong("y comes from green and z from blue: yours are exchanged", [](const Vector& n) {
    return Vector{n.x, n.z, n.y};
  });
  wrong("x comes from red and y from green: yours are exchanged", [](const Vector& n) {
    return Vector{n.y, n.x, n.z};
  });
  wrong("all three numbers come from red: y needs green, and z needs blue", [](const Vector& n) {
    return Vector{n.x, n.x, n.x};
  });
  wrong("z comes from blue: yours comes from green", [](const Vector& n) {
    return Vector{n.x, n.y, n.y};
  });
  wrong("y comes from green: yours comes from red", [](const Vector& n) {
    return Vector{n.x, n.x, n.z};
  });
  const char* blue = "blue means 2c - 1, too: 128 is about 0, and 255 is 1";
  wrong(blue, [](const Vector& n) { return Vector{n.x, n.y, (n.z + 1) / 2}; });
  wrong(blue, [](const Vector& n) { return Vector{n.x, n.y, n.z + 1}; });
  const char* rest = "z is in the file: take 2c - 1 of blue, do not compute it from x and y";
  wrong(rest, [](const Vector& n) {
    return Vector{n.x, n.y, std::sqrt(1 - n.x * n.x - n.y * n.y)};
  });
  wrong(rest, [](const Vector& n) {
    return Vector{n.x, n.y, std::sqrt(std::max(0.0, 1 - n.x * n.x - n.y * n.y))};
  });
  wrong(rest, [](const Vector& n) { return Vector{n.x, n.y, 1}; });
  wrong("blue bytes below 128 mean numbers below 0: do not limit z to 0", [](const Vector& n) {
    return Vector{n.x, n.y, std::max(n.z, 0.0)};
  });
  return mistakes;
}

Exercise normal_from_three_bytes() {
  Law<NormalOfTexel> law{
      .right = numbers_of,
      .places = {{"red 255 means x = 1", {255, 128, 128}},
                 {"red 0 means x = -1", {0, 128, 128}},
                 {"green 255 means y = 1: the file is green up", {128, 255, 128}},
                 {"the flat color (128, 128, 255) means z = 1, and x and y of 1/255",
                  {128, 128, 255}},
                 {"(128, 218, 218) leans by 45 degrees toward B", {128, 218, 218}},
                 {"(51, 102, 204) means (-0.6, -0.2, 0.6)", {51, 102, 204}},
                 {"blue 51 means z = -0.6", {204, 102, 51}}},
      .mistakes = wrong_texels()};
  return exercise("11.2", "Vec3 normal_of_texel(int red, int green, int blue)", std::move(law),
                  normal_of_texel, globe);
}

using BitangentOf = Vector(Vector, Vector, double);

/// Signs of n x T as many use them.
void add_wrong_signs(std::vector<Mistake<BitangentOf>>& mistakes) {
  const auto wrong = [&](const char* word, Vector (*function)(Vector, Vector, double)) {
    mistakes.push_back({word, function});
  };
  wrong("the sign is not used: on the mirrored copy bumps look like dents along v",
        [](Vector n, Vector t, double) { return cross(n, t); });
  wrong("the order matters: n x T, not T x n. Everywhere bumps look like dents along v",
        [](Vector n, Vector t, double sign) { return cross(t, n) * sign; });
  wrong("the order is n x T, and the sign is not used: only the mirrored copy looks right",
        [](Vector n, Vector t, double) { return cross(t, n); });
  wrong("on the mirrored copy your B is (0, 0, 0): it is n x T times -1 there",
        [](Vector n, Vector t, double sign) { return cross(n, t) * std::max(sign, 0.0); });
  const char* one = "the sign turns all three numbers of n x T around: yours turns one alone";
  wrong(one, [](Vector n, Vector t, double sign) {
    const Vector b = cross(n, t);
    return Vector{b.x * sign, b.y, b.z};
  });
  wrong(one, [](Vector n, Vector t, double sign) {
    const Vector b = cross(n, t);
    return Vector{b.x, b.y * sign, b.z};
  });
  wrong(one, [](Vector n, Vector t, double sign) {
    const Vector b = cross(n, t);
    return Vector{b.x, b.y, b.z * sign};
  });
  const char* upward =
      "v need not grow upward: leave B as it is where its y is below 0, and use the sign";
  wrong(upward, [](Vector n, Vector t, double) {
    const Vector b = cross(n, t);
    return b.y < 0 ? b * -1.0 : b;
  });
  wrong(upward, [](Vector n, Vector t, double) {
    const Vector b = cross(n, t);
    return Vector{b.x, std::abs(b.y), b.z};
  });
  wrong("whether a copy is mirrored is in the sign: T alone does not say it",
        [](Vector n, Vector t, double) { return cross(n, t) * (t.x < 0 ? -1.0 : 1.0); });
}

/// Bitangents as many compute them.
std::vector<Mistake<BitangentOf>> wrong_bitangents() {
  std::vector<Mistake<BitangentOf>> mistakes;
  add_wrong_signs(mistakes);
  /// Without the sign and with it, as they are and of length 1.
  const auto wrong_vector = [&](const char* word, Vector (*vector)(const Vector&, const Vector&)) {
    for (const bool with_sign : {true, false}) {
      for (const bool unit : {true, false}) {
        mistakes.push_back({word, [=](Vector n, Vector t, double sign) {
                              const Vector b = vector(n, t) * (with_sign ? sign : 1);
                              return unit ? normalize(b) : b;
                            }});
      }
    }
  };
  wrong_vector("+y is not along the surface where n leans up or down, and v need not grow that way",
               [](const Vector&, const Vector&) {
                 return Vector{0, 1, 0};
               });
  const char* sum = "sums of n and T lie in their plane: cross(n, T) is at a right angle to both";
  wrong_vector(sum, [](const Vector& n, const Vector& t) { return n + t; });
  wrong_vector(sum, [](const Vector& n, const Vector& t) { return n - t; });
  wrong_vector(sum, [](const Vector& n, const Vector& t) { return t - n; });
  wrong_vector("this is T: B is at a right angle to it, and to n",
               [](const Vector&, const Vector& t) { return t; });
  wrong_vector("this is n: B is at a right angle to it, and to T",
               [](const Vector& n, const Vector&) { return n; });
  const char* north = "take cross(n, T): the T of the picture counts, not +y";
  wrong_vector(north, [](const Vector& n, const Vector&) { return cross(Vector{0, 1, 0}, n); });
  wrong_vector(north, [](const Vector& n, const Vector&) { return cross(n, Vector{0, 1, 0}); });
  wrong_vector(north, [](const Vector& n, const Vector&) {
    return cross(n, cross(Vector{0, 1, 0}, n));
  });
  const char* side = "B is at a right angle to n, too: cross(n, T), without an axis";
  wrong_vector(side, [](const Vector&, const Vector& t) { return cross(Vector{0, 1, 0}, t); });
  wrong_vector(side, [](const Vector&, const Vector& t) { return cross(t, Vector{0, 1, 0}); });
  wrong_vector(side, [](const Vector&, const Vector& t) { return cross(Vector{0, 0, 1}, t); });
  wrong_vector(side, [](const Vector&, const Vector& t) { return cross(t, Vector{0, 0, 1}); });
  wrong_vector("your B has no direction: all its numbers are 0. Take cross(n, T)",
               [](const Vector&, const Vector&) {
                 return Vector{0, 0, 0};
               });
  const char* component = "this is no cross product: it is short to write cross(n, T)";
  wrong_vector(component, [](const Vector& n, const Vector& t) {
    return Vector{n.x * t.x, n.y * t.y, n.z * t.z};
  });
  wrong_vector(component, [](const Vector& n, const Vector& t) {
    return Vector{n.y * t.z, n.z * t.x, n.x * t.y};
  });
  wrong_vector(component, [](const Vector& n, const Vector& t) {
    return Vector{n.y * t.z + n.z * t.y, n.z * t.x + n.x * t.z, n.x * t.y + n.y * t.x};
  });
  wrong_vector("the middle number of your cross product has the wrong sign: n.z T.x - n.x T.z",
               [](const Vector& n, const Vector& t) {
                 const Vector b = cross(n, t);
                 return Vector{b.x, -b.y, b.z};
               });
  return mistakes;
}

Exercise bitangent_of_a_copy() {
  Law<BitangentOf> law{
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
                 {"on the back, n = (0, 0, -1), T = (-1, 0, 0): B is (0, 1, 0)",
                  {Vector{0, 0, -1}, Vector{-1, 0, 0}, 1}},
                 {"north of the equator, n = (0, 0.6, 0.8), T = (1, 0, 0): B leans back",
                  {Vector{0, 0.6, 0.8}, Vector{1, 0, 0}, 1}},
                 {"the same on a mirrored copy", {Vector{0, 0.6, 0.8}, Vector{-1, 0, 0}, -1}},
                 {"where the picture is turned by a quarter, T = (0, 1, 0): B is (-1, 0, 0)",
                  {Vector{0, 0, 1}, Vector{0, 1, 0}, 1}},
                 {"where it is upside down, T = (-1, 0, 0) and the sign is 1: B is (0, -1, 0)",
                  {Vector{0, 0, 1}, Vector{-1, 0, 0}, 1}},
                 {"n = (2, 1, 2) / 3, T = (-2, 2, 1) / 3, mirrored: B is (1, 2, -2) / 3",
                  {Vector{2 / 3., 1 / 3., 2 / 3.}, Vector{-2 / 3., 2 / 3., 1 / 3.}, -1}}},
      .mistakes = wrong_bitangents()};
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
