// The exercises of chapter 12. The lesson's SkyOptions and SkyLight are here structs that call the
// student's functions: when the sky is loaded, and when a direction is drawn.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/app/sampling_options.hpp"
#include "engine/app/sky_options.hpp"
#include "engine/render/develop.hpp"
#include "engine/render/gather.hpp"
#include "exercises.hpp"
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

Exercise light_from_four_bytes() {
  const auto of_bytes = [](const std::function<double(int byte, int exponent)>& channel) {
    return [=](int red, int green, int blue, int exponent) {
      return Light{channel(red, exponent), channel(green, exponent), channel(blue, exponent)};
    };
  };
  const auto channel = [](int byte, int exponent) {
    return byte == 0 ? 0 : std::ldexp(byte + 0.5, exponent - 136);
  };
  const auto right = of_bytes(channel);
  Law<Light(int, int, int, int)> law{
      .right = right,
      .places = {{"with the exponent 136 a byte m means m + 1/2", {200, 100, 50, 136}},
                 {"a byte 0 has no light", {200, 0, 0, 136}},
                 {"one less in the exponent is half of the light", {200, 100, 50, 135}},
                 {"a gray of about 1/2: the byte 127 with the exponent 128", {127, 127, 127, 128}},
                 {"the sun: the exponent 138", {225, 195, 147, 138}},
                 {"a very dark blue", {130, 140, 160, 120}}},
      .mistakes =
          {{"the exponent is k - 136, because m has 8 bits: your light is 256 times as "
            "bright",
            of_bytes([=](int m, int k) { return 256 * channel(m, k); })},
           {"the half is missing: the file's writer cuts m off, and m + 1/2 is the middle",
            of_bytes([](int m, int k) { return std::ldexp(m, k - 136); })},
           {"a byte 0 has no light: here the half must not be added",
            of_bytes([](int m, int k) { return std::ldexp(m + 0.5, k - 136); })},
           {"red and blue are exchanged (BGR in place of RGB)",
            [=](int red, int green, int blue, int k) { return right(blue, green, red, k); }},
           {"the exponent is not used: the brightest light is 1, as in a PNG file",
            of_bytes([](int m, int) { return m / 255.0; })},
           {"2 ^ x is no power in C++ (it compares bits): use std::exp2(x)",
            of_bytes([](int m, int k) { return m == 0 ? 0 : (m + 0.5) * (2 ^ (k - 136)); })},
           {"k - 136 is the exponent of 2; you multiply by it",
            of_bytes([](int m, int k) { return m == 0 ? 0 : (m + 0.5) * (k - 136); })}},
      .tolerance = 1e-9};
  return exercise("12.1", "Color light_of_texel(int red, int green, int blue, int exponent)",
                  std::move(law), light_of_texel, without_noise);
}

Exercise angle_of_a_texel() {
  Law<double(int, int, int)> law{
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
      .mistakes = {}};
  const auto wrong = [&](const char* word,
                         const std::function<double(double, double, double)>& function) {
    law.mistakes.push_back(
        {word, [=](int row, int width, int height) { return function(row, width, height); }});
  };
  const auto right = law.right;
  wrong("the sine is missing: texels at the poles count as much as those at the equator",
        [](double, double width, double height) { return 2 * pi * pi / width / height; });
  wrong("all texels have the same part of 4 pi: on the picture, but not on the sphere",
        [](double, double width, double height) { return 4 * pi / width / height; });
  wrong("this is the sine in the middle of the row: close, but use the integral, cos a - cos b",
        [](double row, double width, double height) {
          return 2 * pi * pi / width / height * std::sin(pi * (row + 0.5) / height);
        });
  wrong("this is the sine at the row's upper edge: the first row vanishes. Use cos a - cos b",
        [](double row, double width, double height) {
          return 2 * pi * pi / width / height * std::sin(pi * row / height);
        });
  wrong("cos a - cos b, not cos b - cos a: a solid angle is above 0",
        [=](double row, double width, double height) {
          return -right(static_cast<int>(row), static_cast<int>(width), static_cast<int>(height));
        });
  wrong("this is the solid angle of the whole row: divide by the width",
        [=](double row, double width, double height) {
          return width *
                 right(static_cast<int>(row), static_cast<int>(width), static_cast<int>(height));
        });
  wrong("std::cos takes radians: the polar angle runs to pi, not to 180",
        [](double row, double width, double height) {
          return 2 * pi / width *
                 (std::cos(180 * row / height) - std::cos(180 * (row + 1) / height));
        });
  wrong("the turn around the axis is 2 pi, the polar angle only pi: you use 2 pi for both",
        [](double row, double width, double height) {
          return 2 * pi / width *
                 (std::cos(2 * pi * row / height) - std::cos(2 * pi * (row + 1) / height));
        });
  return exercise("12.2", "double solid_angle(int row, int width, int height)", std::move(law),
                  solid_angle, without_noise);
}

Exercise draw_one_of_many() {
  const auto first_above = [](const Sums& sums, double r) {
    return static_cast<int>(std::upper_bound(sums.begin(), sums.end(), r) - sums.begin());
  };
  const auto right = [=](const Sums& sums, double r) {
    return std::min(first_above(sums, r), static_cast<int>(sums.size()) - 1);
  };
  const Sums three{0.5, 0.5, 1}, sun{0.1, 0.2, 0.9, 1}, dark{0, 0.25, 1}, rounded{0.4, 0.8, 0.999};
  Law<int(const Sums&, double)> law{
      .right = right,
      .places = {{"of the sums 0.1, 0.2, 0.9, 1 the number 0.05 draws thing 0", {sun, 0.05}},
                 {"0.15 draws thing 1", {sun, 0.15}},
                 {"0.5 draws thing 2: its probability is 0.7", {sun, 0.5}},
                 {"0.95 draws the last thing, 3", {sun, 0.95}},
                 {"of the sums 0.5, 0.5, 1 the number 0.5 draws thing 2: thing 1 has the "
                  "probability 0",
                  {three, 0.5}},
                 {"of the sums 0, 0.25, 1 the number 0 draws thing 1: thing 0 has the "
                  "probability 0",
                  {dark, 0}},
                 {"of the sums 0.4, 0.8, 0.999 the number 0.9995 draws the last thing, 2",
                  {rounded, 0.9995}}},
      .mistakes = {
          {"the sums are not used: all things are equally likely, the sun as much as a cloud",
           [](const Sums& sums, double r) {
             return static_cast<int>(r * static_cast<double>(sums.size()));
           }},
          {"nothing is left if r is not below the last sum: limit the index to the last thing",
           first_above},
          {"your index is one too large: you draw the thing after the right one",
           [=](const Sums& sums, double r) { return first_above(sums, r) + 1; }},
          {"your index is one too large: you draw the thing after the right one",
           [=](const Sums& sums, double r) {
             return std::min(first_above(sums, r) + 1, static_cast<int>(sums.size()) - 1);
           }},
          {"your index is one too small: you draw the thing before the right one",
           [=](const Sums& sums, double r) { return std::max(right(sums, r) - 1, 0); }},
          {"your index is one too small: you draw the thing before the right one",
           [=](const Sums& sums, double r) { return first_above(sums, r) - 1; }},
          {"r < sums[i], not r <= sums[i]: a thing with the probability 0 is drawn",
           [](const Sums& sums, double r) {
             const auto at = std::lower_bound(sums.begin(), sums.end(), r) - sums.begin();
             return std::min(static_cast<int>(at), static_cast<int>(sums.size()) - 1);
           }},
          {"r < sums[i], not r <= sums[i], and limit the index to the last thing",
           [](const Sums& sums, double r) {
             return static_cast<int>(std::lower_bound(sums.begin(), sums.end(), r) - sums.begin());
           }}}};
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
  const LightImage& map = lesson.environment.picture.map();
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
