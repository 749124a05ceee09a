// The exercises of chapter 12. The lesson's SkyOptions and SkyLight are here structs that call the
// student's functions: when the sky is loaded, and when a direction is drawn.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/app/sampling_options.hpp"
#include "engine/app/sky_options.hpp"
#include "engine/render/develop.hpp"
#include "engine/render/gather.hpp"
#include "exercises.hpp"
#include "math/srgb.hpp"
#include "sampling/directions.hpp"
#include "texture/sky_texels.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::check {

static Hook<Color<double>(int, int, int, int)> light_of_texel;
static Hook<double(int, int, int)> solid_angle;
static Hook<int(const std::vector<double>&, double)> drawn_thing;

}  // namespace texmap::check

namespace texmap::chapter_12 {

/// A picture of the sky as the student reads its texels, each first written as in a .hdr file.
inline LightImage read_by_student(LightImage map) {
  for (Color<float>& texel : map.texels) {
    const double brightest = std::max({texel.r, texel.g, texel.b});
    const int k = brightest > 0 ? std::ilogb(brightest) + 129 : 0;
    const auto byte = [k](float light) {
      return static_cast<int>(std::ldexp(static_cast<double>(light), 136 - k));
    };
    const Color<double> light =
        check::light_of_texel.yours(byte(texel.r), byte(texel.g), byte(texel.b), k);
    texel = number_cast<float>(light);
  }
  return map;
}

/// The same picture, brighter where the student takes a texel for larger than it is: its sums over
/// all directions are then the student's.
inline LightImage weighted_by_student(LightImage map) {
  for (int row = 0; row < map.height; ++row) {
    const double weight = check::solid_angle.yours(row, map.width, map.height) /
                          SkyBand(row, map.width, map.height).solid_angle;
    for (int column = 0; column < map.width; ++column)
      map.at(column, row) = map.at(column, row) * static_cast<float>(weight);
  }
  return map;
}

struct SkyLight : texmap::SkyLight {
  std::vector<double> row_sums;                 ///< of the probabilities of all rows
  std::vector<std::vector<double>> texel_sums;  ///< of those of a row's texels, if it is drawn

  SkyLight() = default;
  explicit SkyLight(texmap::SkyLight sky) : texmap::SkyLight(std::move(sky)) {
    const Environment& loaded = picture;
    if (check::light_of_texel) {
      picture = Environment(read_by_student(loaded.map()), loaded.filter());
      moments = SkyMoments(picture);
    }
    if (check::solid_angle) moments = SkyMoments(Environment(weighted_by_student(loaded.map())));
    if (check::drawn_thing) sum_up();
  }

  Vec3<double> direction(const Point2<double>& texel, const Point2<double>& within) const {
    const int row = one_of(row_sums, texel.v);
    const int column = one_of(texel_sums[static_cast<std::size_t>(row)], texel.u);
    return picture.from_map(direction_rtiow(Uv<double>{
        (column + within.u) / picture.map().width, 1 - (row + within.v) / picture.map().height}));
  }

 private:
  /// What the student draws; the first if there is no such thing.
  static int one_of(const std::vector<double>& sums, double r) {
    const int thing = check::drawn_thing.yours(sums, r);
    return thing >= 0 && thing < static_cast<int>(sums.size()) ? thing : 0;
  }
  void sum_up() {
    const auto width = static_cast<std::size_t>(picture.map().width);
    double all = 0;
    for (std::size_t first = 0; first < sampler.probabilities().size(); first += width) {
      std::vector<double>& sums = texel_sums.emplace_back();
      sums.reserve(width);
      double row = 0;
      for (std::size_t i = 0; i < width; ++i) {
        row += sampler.probabilities()[first + i];
        sums.push_back(row);
      }
      for (double& sum : sums) sum /= row;
      all += row;
      row_sums.push_back(all);
    }
  }
};

struct SkyStage {
  Camera camera{};
  SkyLight sky{};
};

struct SkyOptions : texmap::SkyOptions {
  [[nodiscard]] SkyLight load(const Session& session) {
    return SkyLight(texmap::SkyOptions::load(session));
  }
};

}  // namespace texmap::chapter_12

#include "12_environment_map/lesson.hpp"

namespace texmap::check {
namespace {

using chapter_12::Lesson;
using Light = Color<double>;
using Sums = std::vector<double>;

constexpr double pi = std::numbers::pi;

Image scene(const char* way, int samples) {
  const auto lesson = prepared<Lesson>({"--light", way, "--filter", "nearest"});
  const View<> view = view_of(lesson.stage.camera, 400, 300);
  return develop(
      gather<double>(lesson, lesson.objects, view, {Sampler(SamplerKind::sobol, samples)}, {}, {}),
      Transfer::srgb);
}
/// Without random directions, so that one sample is enough.
Image without_noise() { return scene("coefficients", 1); }

using LightOfTexel = Light(int, int, int, int);

/// The light of a channel with the byte m and the exponent k.
double light_of(int m, int k) { return m == 0 ? 0 : std::ldexp(m + 0.5, k - 136); }
Light light_of_bytes(int red, int green, int blue, int k) {
  return {light_of(red, k), light_of(green, k), light_of(blue, k)};
}

/// Powers of 2 as many write them: with the right factor, without the half, and with the half also
/// where the byte is 0.
void add_wrong_powers(std::vector<Mistake<LightOfTexel>>& mistakes) {
  const auto wrong = [&](const char* word, double (*power)(int k)) {
    for (const double half : {0.5, 0.0}) {
      for (const bool light_of_0 : {false, true}) {
        const auto light = [=](int m, int k) {
          return m == 0 && !light_of_0 ? 0 : (m + half) * power(k);
        };
        mistakes.push_back({word, [=](int red, int green, int blue, int k) {
                              return Light{light(red, k), light(green, k), light(blue, k)};
                            }});
      }
    }
  };
  wrong("the exponent is k - 136, because m has 8 bits: your light is 256 times as bright",
        [](int k) { return std::ldexp(1, k - 128); });
  wrong("2 ^ x is no power in C++ (it compares bits): use std::exp2(x)",
        [](int k) { return 1.0 * (2 ^ (k - 136)); });
  wrong("k - 136 is the exponent of 2; you multiply by it", [](int k) { return k - 136.0; });
  wrong("k - 136 is the exponent of 2: 2 * x is no power, std::exp2(x) is",
        [](int k) { return 2 * (k - 136.0); });
  wrong("1 << x shifts by no number below 0, and a dark texel has one: use std::exp2(x)",
        [](int k) {
          // What today's processors do: they take the lowest five bits.
          return 1.0 * static_cast<int>(1U << (static_cast<unsigned>(k - 136) & 31U));
        });
  wrong("a step of m is 1 / 256 of 2^(k - 128), not 1 / 255: m + 1/2 runs from 1/2 to 255 1/2",
        [](int k) { return std::ldexp(1 / 255.0, k - 128); });
  const char* bits = "136 has the 8 bits of m in it already: do not divide m by 255 or 256, too";
  wrong(bits, [](int k) { return std::ldexp(1 / 255.0, k - 136); });
  wrong(bits, [](int k) { return std::ldexp(1 / 256.0, k - 136); });
  wrong("the exponent is k - 136: your light is twice as bright",
        [](int k) { return std::ldexp(1, k - 135); });
  wrong("the exponent is k - 136: your light is half as bright",
        [](int k) { return std::ldexp(1, k - 137); });
  wrong("the exponent has the wrong sign: it is k - 136, and a larger k is more light",
        [](int k) { return std::ldexp(1, 136 - k); });
  wrong("std::exp(x) is the power of e, 2.718: use std::exp2(x)",
        [](int k) { return std::exp(k - 136); });
  wrong("this is a power of 10: use std::exp2(x)", [](int k) { return std::pow(10, k - 136); });
  wrong("std::pow takes the base first: std::pow(2, x), or std::exp2(x)",
        [](int k) { return (k - 136.0) * (k - 136.0); });
  wrong("136 is subtracted from the exponent, before the power: std::exp2(exponent - 136)",
        [](int k) { return std::exp2(k) - 136; });
  wrong("a power of 2 below 1 is 0 as an int: keep it in a double",
        [](int k) { return std::floor(std::ldexp(1, k - 136)); });
  const char* unused = "the exponent is not used: the brightest light is 1, as in a PNG file";
  wrong(unused, [](int) { return 1 / 255.0; });
  wrong(unused, [](int) { return 1 / 256.0; });
  wrong("the exponent is not used: multiply by 2 to the power k - 136", [](int) { return 1.0; });
}

/// Channels as many compute them.
void add_wrong_channels(std::vector<Mistake<LightOfTexel>>& mistakes) {
  const auto wrong = [&](const char* word, double (*light)(int m, int k)) {
    mistakes.push_back({word, [=](int red, int green, int blue, int k) {
                          return Light{light(red, k), light(green, k), light(blue, k)};
                        }});
  };
  wrong("the half is missing: the file's writer cuts m off, and m + 1/2 is the middle",
        [](int m, int k) { return std::ldexp(m, k - 136); });
  const char* order = "* comes before +: write (m + 0.5) * the power";
  wrong(order, [](int m, int k) { return std::ldexp(m, k - 136) + 0.5; });
  wrong(order, [](int m, int k) { return m == 0 ? 0 : std::ldexp(m, k - 136) + 0.5; });
  wrong(order, [](int m, int k) { return m + std::ldexp(0.5, k - 136); });
  wrong(order, [](int m, int k) { return m == 0 ? 0 : m + std::ldexp(0.5, k - 136); });
  const char* base =
      "the base of the power is 2, not m + 1/2: multiply that by std::exp2(exponent - 136)";
  wrong(base, [](int m, int k) { return std::pow(m + 0.5, k - 136); });
  wrong(base, [](int m, int k) { return m == 0 ? 0 : std::pow(m + 0.5, k - 136); });
  const char* half = "it is m + 1/2: the middle between m and m + 1";
  wrong(half, [](int m, int k) { return std::ldexp(m - 0.5, k - 136); });
  wrong(half, [](int m, int k) { return m == 0 ? 0 : std::ldexp(m - 0.5, k - 136); });
  wrong(half, [](int m, int k) { return std::ldexp(m + 1, k - 136); });
  wrong(half, [](int m, int k) { return m == 0 ? 0 : std::ldexp(m + 1, k - 136); });
  const char* limit = "light may be far above 1, as the sun's is: do not limit it";
  wrong(limit, [](int m, int k) { return std::min(light_of(m, k), 1.0); });
  wrong(limit, [](int m, int k) { return std::min(std::ldexp(m + 0.5, k - 136), 1.0); });
  wrong(limit, [](int m, int k) { return std::min(std::ldexp(m, k - 136), 1.0); });
  wrong("the light of a channel is no whole number: keep it in a double",
        [](int m, int k) { return std::floor(light_of(m, k)); });
  wrong("the exponent is not used, and the bytes of this file are light: leave srgb_decode out",
        [](int m, int) { return srgb_decode(m / 255.0); });
  wrong("the numbers of this file are light: leave srgb_decode out",
        [](int m, int k) { return srgb_decode(light_of(m, k)); });
  wrong("the picture's program encodes the light: leave srgb_encode out",
        [](int m, int k) { return srgb_encode(light_of(m, k)); });
}

/// Lights as many compute them.
std::vector<Mistake<LightOfTexel>> wrong_lights() {
  std::vector<Mistake<LightOfTexel>> mistakes;
  add_wrong_powers(mistakes);
  add_wrong_channels(mistakes);
  const auto wrong = [&](const char* word, Light (*light)(int, int, int, int)) {
    mistakes.push_back({word, light});
  };
  for (int guarded = 0; guarded < 7; ++guarded) {  // a bit for each channel where 0 is no light
    mistakes.push_back({"a byte 0 has no light: here the half must not be added",
                        [=](int red, int green, int blue, int k) {
                          const auto light = [=](int m, int bit) {
                            return (guarded & bit) != 0 ? light_of(m, k)
                                                        : std::ldexp(m + 0.5, k - 136);
                          };
                          return Light{light(red, 1), light(green, 2), light(blue, 4)};
                        }});
  }
  wrong("red and blue are exchanged (BGR in place of RGB)",
        [](int red, int green, int blue, int k) { return light_of_bytes(blue, green, red, k); });
  const char* copied = "two channels come from the same byte: look for a line that was copied";
  wrong(copied, [](int red, int, int blue, int k) { return light_of_bytes(red, red, blue, k); });
  wrong(copied,
        [](int red, int green, int, int k) { return light_of_bytes(red, green, green, k); });
  wrong(copied, [](int red, int green, int, int k) { return light_of_bytes(red, green, red, k); });
  wrong("all channels come from red: the texel is gray",
        [](int red, int, int, int k) { return light_of_bytes(red, red, red, k); });
  const char* own = "each channel has its own byte: one that is 0 leaves the others as they are";
  wrong(own, [](int red, int green, int blue, int k) {
    return red == 0 || green == 0 || blue == 0 ? Light{} : light_of_bytes(red, green, blue, k);
  });
  wrong(own, [](int red, int green, int blue, int k) {
    return red == 0 ? Light{} : light_of_bytes(red, green, blue, k);
  });
  wrong(own, [](int red, int green, int blue, int k) {
    return red == 0 ? Light{} : Light{red + 0.5, green + 0.5, blue + 0.5} * std::exp2(k - 136);
  });
  return mistakes;
}

Exercise light_from_four_bytes() {
  Law<LightOfTexel> law{
      .right = light_of_bytes,
      .places = {{"with the exponent 136 a byte m means m + 1/2", {200, 100, 50, 136}},
                 {"a byte 0 has no light", {200, 0, 0, 136}},
                 {"a byte 0 in red alone: the others have their light", {0, 120, 60, 132}},
                 {"one less in the exponent is half of the light", {200, 100, 50, 135}},
                 {"a gray of about 1/2: the byte 127 with the exponent 128", {127, 127, 127, 128}},
                 {"the sun: the exponent 138", {225, 195, 147, 138}},
                 {"a very dark blue", {130, 140, 160, 120}}},
      .mistakes = wrong_lights(),
      .tolerance = 1e-9};
  return exercise("12.1", "Color light_of_texel(int red, int green, int blue, int exponent)",
                  std::move(law), light_of_texel, without_noise);
}

using SolidAngle = double(int, int, int);

Mistake<SolidAngle> wrong_angle(const char* word,
                                std::function<double(double, double, double)> angle) {
  return {word, [angle = std::move(angle)](int row, int width, int height) {
            return angle(row, width, height);
          }};
}

/// Sines in the place of the integral, with several factors.
void add_sines(std::vector<Mistake<SolidAngle>>& mistakes) {
  const auto wrong = [&](const char* word, double (*sine)(double row, double height)) {
    for (const double factor : {2 * pi * pi, 4 * pi, 2 * pi, pi * pi}) {
      mistakes.push_back(wrong_angle(word, [=](double row, double width, double height) {
        return factor / width / height * sine(row, height);
      }));
    }
    mistakes.push_back(wrong_angle(word, [=](double row, double width, double height) {
      return 2 * pi / width * sine(row, height);
    }));
  };
  const char* middle =
      "this is the sine in the middle of the row: close, but use the integral, cos a - cos b";
  wrong(middle, [](double row, double height) { return std::sin(pi * (row + 0.5) / height); });
  wrong("this is the sine at the row's upper edge: the first row vanishes. Use cos a - cos b",
        [](double row, double height) { return std::sin(pi * row / height); });
  wrong("this is the sine at the row's lower edge: the last row vanishes. Use cos a - cos b",
        [](double row, double height) { return std::sin(pi * (row + 1) / height); });
  wrong("this is the mean of two sines: close, but use the integral, cos a - cos b",
        [](double row, double height) {
          return (std::sin(pi * row / height) + std::sin(pi * (row + 1) / height)) / 2;
        });
}

/// Edges as many compute them.
void add_wrong_edges(std::vector<Mistake<SolidAngle>>& mistakes) {
  const auto wrong = [&](const char* word, double (*edge)(double row, double height)) {
    mistakes.push_back(wrong_angle(word, [=](double row, double width, double height) {
      return 2 * pi / width * (std::cos(edge(row, height)) - std::cos(edge(row + 1, height)));
    }));
  };
  /// Only the lower edge.
  const auto wrong_lower = [&](const char* word, double (*edge)(double row, double height)) {
    mistakes.push_back(wrong_angle(word, [=](double row, double width, double height) {
      return 2 * pi / width * (std::cos(pi * row / height) - std::cos(edge(row, height)));
    }));
  };
  const char* degrees = "std::cos takes radians: the polar angle runs to pi, not to 180";
  wrong(degrees, [](double row, double height) { return 180 * row / height; });
  wrong(degrees, [](double row, double height) { return std::floor(180 * row / height); });
  wrong("the turn around the axis is 2 pi, the polar angle only pi: you use 2 pi for both",
        [](double row, double height) { return 2 * pi * row / height; });
  wrong("the polar angle runs from 0 to pi: yours ends at the equator",
        [](double row, double height) { return pi / 2 * row / height; });
  const char* whole =
      "row / height divides whole numbers, and the rest is lost: write pi * row / height";
  wrong(whole, [](double row, double height) { return pi * std::floor(row / height); });
  wrong(whole, [](double row, double height) { return std::floor(row / height); });
  wrong("pi is missing: the polar angle of an edge is pi * row / height",
        [](double row, double height) { return row / height; });
  wrong("an edge is row times pi / height, not row alone", [](double row, double) { return row; });
  wrong("your edges are one row too far down: row 0 begins at the polar angle 0",
        [](double row, double height) { return pi * (row + 1) / height; });
  wrong("your edges are one row too far up: row 0 begins at the polar angle 0",
        [](double row, double height) { return pi * (row - 1) / height; });
  const char* centers = "row 0 begins at the polar angle 0: leave the half out";
  wrong(centers, [](double row, double height) { return pi * (row - 0.5) / height; });
  wrong(centers, [](double row, double height) { return pi * (row + 0.5) / height; });
  wrong("there are height rows, and the last one ends at pi: divide by height, not by height - 1",
        [](double row, double height) { return pi * row / (height - 1); });
  const char* brackets =
      "the lower edge needs brackets: it is pi * (row + 1) / height, the edge of the next row";
  wrong_lower(brackets, [](double row, double height) { return pi * row + 1 / height; });
  wrong_lower(brackets, [](double row, double) { return pi * row; });
  wrong_lower(brackets, [](double row, double) { return pi * row + 1; });
  wrong_lower(brackets, [](double row, double height) { return (pi * row + 1) / height; });
  wrong_lower(brackets, [](double row, double height) { return pi * row / height + 1; });
  wrong_lower(brackets, [](double row, double height) { return pi * (row / height + 1); });
  wrong_lower(brackets, [](double row, double height) { return pi * (row + 1 / height); });
  wrong_lower(brackets, [](double row, double height) { return row + pi / height; });
  wrong_lower("both edges are the same: the lower edge is that of row + 1",
              [](double row, double height) { return pi * row / height; });
  wrong_lower("the lower edge is that of row + 1: yours is that of row - 1",
              [](double row, double height) { return pi * (row - 1) / height; });
  wrong_lower("the lower edge is that of row + 1: with pi it is the south pole",
              [](double, double) { return pi; });
}

/// Factors before cos a - cos b as many compute them, and with cos b - cos a.
void add_wrong_factors(std::vector<Mistake<SolidAngle>>& mistakes) {
  const auto wrong = [&](const char* word, double (*factor)(double width, double height)) {
    for (const double sign : {1, -1}) {
      mistakes.push_back(wrong_angle(word, [=](double row, double width, double height) {
        return sign * factor(width, height) *
               (std::cos(pi * row / height) - std::cos(pi * (row + 1) / height));
      }));
    }
  };
  wrong("this is the solid angle of the whole row: divide by the width",
        [](double, double) { return 2 * pi; });
  wrong("the turn around the axis is 2 pi, not pi: all texels together have only half of 4 pi",
        [](double width, double) { return pi / width; });
  wrong("the turn around the axis is 2 pi, not 4 pi: all texels together have twice 4 pi",
        [](double width, double) { return 4 * pi / width; });
  wrong("2 pi is missing: a texel covers 2 pi / width of the turn",
        [](double width, double) { return 1 / width; });
  wrong("multiply by 2 pi / width: a texel is only a part of the turn around the axis",
        [](double, double) { return 1.0; });
  wrong("std::cos takes radians, and so does the turn around the axis: it is 2 pi, not 360",
        [](double width, double) { return 360 / width; });
  const char* twice = "cos a - cos b has the row's height in it: leave out the other height";
  wrong(twice, [](double width, double height) { return 2 * pi / width * (pi / height); });
  wrong(twice, [](double width, double height) { return 2 * pi / width / height; });
  wrong(twice, [](double width, double height) { return 4 * pi / width / height; });
  wrong("divide 2 pi by the width: you multiply",
        [](double width, double) { return 2 * pi * width; });
  wrong("the width divides the turn, and the height the polar angle: you divide by the height here",
        [](double, double height) { return 2 * pi / height; });
}

/// Solid angles as many compute them.
std::vector<Mistake<SolidAngle>> wrong_solid_angles() {
  std::vector<Mistake<SolidAngle>> mistakes;
  const auto wrong = [&](const char* word, double (*angle)(double, double, double)) {
    mistakes.push_back(wrong_angle(word, angle));
  };
  /// From the two edges, without the factor 2 pi / width.
  const auto wrong_integral = [&](const char* word, double (*integral)(double a, double b)) {
    mistakes.push_back(wrong_angle(word, [=](double row, double width, double height) {
      return 2 * pi / width * integral(pi * row / height, pi * (row + 1) / height);
    }));
  };
  wrong("the sine is missing: texels at the poles count as much as those at the equator",
        [](double, double width, double height) { return 2 * pi * pi / width / height; });
  wrong("all texels have the same part of 4 pi: on the picture, but not on the sphere",
        [](double, double width, double height) { return 4 * pi / width / height; });
  wrong_integral("cos a - cos b, not cos b - cos a: a solid angle is above 0",
                 [](double a, double b) { return std::cos(b) - std::cos(a); });
  wrong_integral("the cosines are subtracted, not added: the integral is cos a - cos b",
                 [](double a, double b) { return std::cos(a) + std::cos(b); });
  wrong_integral("the cosines are subtracted, not multiplied: the integral is cos a - cos b",
                 [](double a, double b) { return std::cos(a) * std::cos(b); });
  const char* difference = "the integral is cos a - cos b, not the cosine of a - b";
  wrong_integral(difference, [](double a, double b) { return std::cos(a - b); });
  wrong_integral(difference, [](double a, double b) { return 1 - std::cos(a - b); });
  const char* sines =
      "take cos a - cos b, with angles from the pole: yours are sines, or angles from the equator";
  wrong_integral(sines, [](double a, double b) { return std::sin(a) - std::sin(b); });
  wrong_integral(sines, [](double a, double b) { return std::sin(b) - std::sin(a); });
  wrong_integral("this is all from the north pole down to b: it is cos a - cos b, not 1 - cos b",
                 [](double, double b) { return 1 - std::cos(b); });
  wrong_integral("this is all from the north pole down to a: it is cos a - cos b, not 1 - cos a",
                 [](double a, double) { return 1 - std::cos(a); });
  wrong_integral("cos b is missing: the integral is cos a - cos b",
                 [](double a, double) { return std::cos(a); });
  wrong("* comes before -: put brackets around cos a - cos b",
        [](double row, double width, double height) {
          return 2 * pi / width * std::cos(pi * row / height) - std::cos(pi * (row + 1) / height);
        });
  wrong("width and height are exchanged: rows divide the polar angle by the height",
        [](double row, double width, double height) {
          return 2 * pi / height * (std::cos(pi * row / width) - std::cos(pi * (row + 1) / width));
        });
  wrong("the polar angle is divided by the height: you divide it by the width",
        [](double row, double width, double) {
          return 2 * pi / width * (std::cos(pi * row / width) - std::cos(pi * (row + 1) / width));
        });
  add_sines(mistakes);
  add_wrong_edges(mistakes);
  add_wrong_factors(mistakes);
  return mistakes;
}

Exercise angle_of_a_texel() {
  Law<SolidAngle> law{
      .right = [](int row, int width,
                  int height) { return SkyBand(row, width, height).solid_angle; },
      .places = {{"two rows of one texel: each is half of the sphere, 2 pi", {0, 1, 2}},
                 {"the lower half is as large", {1, 1, 2}},
                 {"8 texels in each of two rows: pi / 4", {0, 8, 2}},
                 {"of 4 rows the first ends at 45 degrees: a narrow texel", {0, 8, 4}},
                 {"of 4 rows the second reaches from 45 degrees to the equator", {1, 8, 4}},
                 {"the last of 4 rows is as large as the first", {3, 8, 4}},
                 {"the first row of the chapter's sky", {0, 384, 192}},
                 {"its row at the equator", {96, 384, 192}}},
      .mistakes = wrong_solid_angles()};
  return exercise("12.2", "double solid_angle(int row, int width, int height)", std::move(law),
                  solid_angle, without_noise);
}

using DrawnThing = int(const Sums&, double);

int last_of(const Sums& sums) { return static_cast<int>(sums.size()) - 1; }
int first_above(const Sums& sums, double r) {
  return static_cast<int>(std::upper_bound(sums.begin(), sums.end(), r) - sums.begin());
}
int right_thing(const Sums& sums, double r) {
  return std::min(first_above(sums, r), last_of(sums));
}

/// Searches that many write: the first i that fits, and what is returned if none does.
void add_wrong_searches(std::vector<Mistake<DrawnThing>>& mistakes) {
  enum Otherwise { last, size, none, first };
  using Fits = bool (*)(const Sums&, int i, double r);
  const auto wrong = [&](const char* word, Fits fits, const std::vector<Otherwise>& otherwise) {
    for (const Otherwise other : otherwise) {
      mistakes.push_back({word, [=](const Sums& sums, double r) {
                            for (int i = 0; i <= last_of(sums); ++i)
                              if (fits(sums, i, r)) return i;
                            if (other == last) return last_of(sums);
                            return other == size ? last_of(sums) + 1 : other == none ? -1 : 0;
                          }});
    }
  };
  static constexpr auto at = [](const Sums& sums, int i) {
    return i < 0 ? 0 : sums[static_cast<std::size_t>(i)];
  };
  const Fits above = [](const Sums& sums, int i, double r) { return r < at(sums, i); };
  const Fits not_below = [](const Sums& sums, int i, double r) { return r <= at(sums, i); };
  wrong("nothing is left if r is not below the last sum: limit the index to the last thing", above,
        {size});
  wrong("if rounding left no sum above r, return the last thing, not -1", above, {none});
  wrong("if rounding left no sum above r, return the last thing, not the first", above, {first});
  wrong("r < sums[i], not r <= sums[i]: a thing with the probability 0 is drawn", not_below,
        {last});
  wrong("r < sums[i], not r <= sums[i], and limit the index to the last thing", not_below, {size});
  wrong("r < sums[i], not r <= sums[i], and return the last thing if there is no such i", not_below,
        {none, first});
  const std::vector<Otherwise> all{last, size, none, first};
  const char* below = "the comparison is turned around: find the first i with r < sums[i]";
  const std::vector<Otherwise> but_first{last, size, none};  // where that is another mistake
  wrong(
      below, [](const Sums& sums, int i, double r) { return r > at(sums, i); }, but_first);
  wrong(
      below, [](const Sums& sums, int i, double r) { return r >= at(sums, i); }, but_first);
  wrong(
      "r is hardly ever equal to a sum: find the first i with r < sums[i]",
      [](const Sums& sums, int i, double r) { return r == at(sums, i); }, all);
  wrong(
      "thing 0 is never drawn: begin with i = 0",
      [](const Sums& sums, int i, double r) { return i > 0 && r < at(sums, i); }, all);
  wrong(
      "thing 0 is left out: it is drawn where r is below sums[0], with no sum before it",
      [](const Sums& sums, int i, double r) {
        return i > 0 && r >= at(sums, i - 1) && r < at(sums, i);
      },
      but_first);
  wrong(
      "r may be equal to the sum before: write >= there, or leave that comparison out",
      [](const Sums& sums, int i, double r) { return r > at(sums, i - 1) && r < at(sums, i); },
      all);
  wrong(
      "compare r with sums[i]: you compare it with the probability of thing i alone",
      [](const Sums& sums, int i, double r) { return r < at(sums, i) - at(sums, i - 1); }, all);
  wrong(
      "sums[i] is a sum already: do not add the sums up, and subtract none from r",
      [](const Sums& sums, int i, double r) {
        return r < std::accumulate(sums.begin(), sums.begin() + i + 1, 0.0);
      },
      all);
  wrong(
      "r draws the first sum above it: yours is compared with 1 - r",
      [](const Sums& sums, int i, double r) { return 1 - r < at(sums, i); }, all);
}

/// Things drawn as many do it.
std::vector<Mistake<DrawnThing>> wrong_things() {
  std::vector<Mistake<DrawnThing>> mistakes;
  const auto wrong = [&](const char* word, int (*thing)(const Sums& sums, double r)) {
    mistakes.push_back({word, thing});
  };
  const char* unused =
      "the sums are not used: all things are equally likely, the sun as much as a cloud";
  wrong(unused, [](const Sums& sums, double r) {
    return static_cast<int>(r * static_cast<double>(sums.size()));
  });
  wrong(unused, [](const Sums& sums, double r) { return static_cast<int>(r * last_of(sums)); });
  wrong(unused, [](const Sums& sums, double r) {
    return static_cast<int>(std::lround(r * last_of(sums)));
  });
  const char* large = "your index is one too large: you draw the thing after the right one";
  wrong(large, [](const Sums& sums, double r) { return first_above(sums, r) + 1; });
  wrong(large, [](const Sums& sums, double r) { return right_thing(sums, r) + 1; });
  wrong(large, [](const Sums& sums, double r) {
    return std::min(first_above(sums, r) + 1, last_of(sums));
  });
  const char* small = "your index is one too small: you draw the thing before the right one";
  wrong(small, [](const Sums& sums, double r) { return std::max(right_thing(sums, r) - 1, 0); });
  wrong(small, [](const Sums& sums, double r) { return std::max(first_above(sums, r) - 1, 0); });
  wrong(small, [](const Sums& sums, double r) { return right_thing(sums, r) - 1; });
  wrong(small, [](const Sums& sums, double r) { return first_above(sums, r) - 1; });
  add_wrong_searches(mistakes);
  wrong(
      "the last thing is never drawn: limit the index to sums.size() - 1",
      [](const Sums& sums, double r) { return std::min(first_above(sums, r), last_of(sums) - 1); });
  wrong("you always draw the last thing: begin at the first, and stop where r < sums[i]",
        [](const Sums& sums, double) { return last_of(sums); });
  wrong("you always draw the first thing: go on while r is not below sums[i]",
        [](const Sums&, double) { return 0; });
  const char* goes_on =
      "your search goes on to the last thing: stop at the first i with r < sums[i]";
  wrong(goes_on, [](const Sums& sums, double r) { return r < sums.back() ? last_of(sums) : 0; });
  wrong(goes_on, [](const Sums& sums, double r) { return r < sums.back() ? last_of(sums) : -1; });
  wrong("you count the sums above r: count those that are not above it, up to the last thing",
        [](const Sums& sums, double r) { return last_of(sums) + 1 - first_above(sums, r); });
  wrong("take the first sum above r, not the one nearest to r", [](const Sums& sums, double r) {
    const auto nearer = [=](double a, double b) { return std::abs(a - r) < std::abs(b - r); };
    return static_cast<int>(std::min_element(sums.begin(), sums.end(), nearer) - sums.begin());
  });
  return mistakes;
}

Exercise draw_one_of_many() {
  const Sums three{0.5, 0.5, 1}, sun{0.1, 0.2, 0.9, 1}, dark{0, 0.25, 1}, rounded{0.4, 0.8, 0.999};
  Law<DrawnThing> law{
      .right = right_thing,
      .places =
          {{"of the sums 0.1, 0.2, 0.9, 1 the number 0.05 draws thing 0", {sun, 0.05}},
           {"0.15 draws thing 1", {sun, 0.15}},
           {"0.5 draws thing 2: its probability is 0.7", {sun, 0.5}},
           {"0.95 draws the last thing, 3", {sun, 0.95}},
           {"of the sums 0.02, 0.04, 0.06, 0.08, 1 the number 0.07 draws thing 3",
            {{0.02, 0.04, 0.06, 0.08, 1}, 0.07}},
           {"of the sums 0.25, 0.5, 1 the number 0.5 draws thing 2, not 1: thing 1 ends below it",
            {{0.25, 0.5, 1}, 0.5}},
           {"of the sums 0.5, 0.5, 1 the number 0.5 draws thing 2: thing 1 has the "
            "probability 0",
            {three, 0.5}},
           {"of the sums 0, 0.25, 1 the number 0 draws thing 1: thing 0 has the "
            "probability 0",
            {dark, 0}},
           {"of the sums 0.4, 0.8, 0.999 the number 0.9995 draws the last thing, 2",
            {rounded, 0.9995}}},
      .mistakes = wrong_things()};
  return exercise("12.3", "int drawn_thing(const std::vector<double>& sums, double r)",
                  std::move(law), drawn_thing, [] { return scene("importance", 2); });
}

/// Of a million directions drawn by the cosine on a surface that faces the sun, how many find it.
double directions_to_the_sun() {
  const Vec3<double> to_sun{0, 0, 1};
  const double edge = std::cos(1.4 * pi / 180);
  int found = 0;
  for (int i = 0; i < 1000; ++i) {
    for (int j = 0; j < 1000; ++j) {
      const Point2<double> place{(i + 0.5) / 1000, (j + 0.5) / 1000};
      if (dot(cosine_direction(to_sun, place), to_sun) > edge) ++found;
    }
  }
  return found;
}

double equator_to_pole() {
  const auto lesson = prepared<Lesson>({"--light", "cosine"});
  const LightImage& map = lesson.stage.sky.picture.map();
  return SkyBand(map.height / 2, map.width, map.height).solid_angle /
         SkyBand(0, map.width, map.height).solid_angle;
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      .exercises = {light_from_four_bytes(), angle_of_a_texel(), draw_one_of_many()},
      .questions =
          {{"12.a",
            "The sun is 2.8 degrees wide. Of a million directions drawn by the cosine on a surface "
            "that faces the sun, how many find it?",
            directions_to_the_sun, "directions", 0.1},
           {"12.b",
            "The sky has 384 x 192 texels. How many times as large, on the sphere, is a texel at "
            "the equator as one at a pole?",
            equator_to_pole, "times", 0.02}},
  };
  return chapter;
}

}  // namespace texmap::check
