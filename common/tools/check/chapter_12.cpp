// The exercises of chapter 12. The lesson's SkyOptions and SkyLight are here structs that call the
// student's functions: when the sky is loaded, and when a direction is drawn.
#include <algorithm>
#include <cmath>
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
  for (Color<float>& texel : map.pixels) {
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
    const auto width = static_cast<std::ptrdiff_t>(picture.map().width);
    for (auto p = sampler.probabilities().begin(); p != sampler.probabilities().end();) {
      std::vector<double>& sums = texel_sums.emplace_back(width);
      std::partial_sum(p, p + width, sums.begin());
      p += width;
      const double row = sums.back();
      for (double& sum : sums) sum /= row;
      row_sums.push_back(row_sums.empty() ? row : row_sums.back() + row);
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

/// The light of a channel with the byte m and the exponent k.
double light_of(int m, int k) { return m == 0 ? 0 : std::ldexp(m + 0.5, k - 136); }
Light light_of_bytes(int red, int green, int blue, int k) {
  return {light_of(red, k), light_of(green, k), light_of(blue, k)};
}

/// Powers of 2 as many write them.
Slips<double> wrong_powers(int k) {
  const double x = k - 136.0;
  const double right = std::exp2(x);
  return {
      {"the exponent is k - 136, because m has 8 bits: your light is 256 times as bright",
       right * 256},
      {"2 ^ x is no power in C++ (it compares bits): use std::exp2(x)", 1.0 * (2 ^ (k - 136))},
      {"k - 136 is the exponent of 2; you multiply by it", x},
      {"k - 136 is the exponent of 2: 2 * x is no power, std::exp2(x) is", 2 * x},
      // What today's processors do: they take the lowest five bits.
      {"1 << x shifts by no number below 0, and a dark texel has one: use std::exp2(x)",
       1.0 * static_cast<int>(1U << (static_cast<unsigned>(k - 136) & 31U))},
      {"a step of m is 1 / 256 of 2^(k - 128), not 1 / 255: m + 1/2 runs from 1/2 to 255 1/2",
       right * 256 / 255},
      {"136 has the 8 bits of m in it already: do not divide m by 255 or 256, too",
       {right / 255, right / 256}},
      {"the exponent is k - 136: your light is twice as bright", right * 2},
      {"the exponent is k - 136: your light is half as bright", right / 2},
      {"the exponent has the wrong sign: it is k - 136, and a larger k is more light", 1 / right},
      {"std::exp(x) is the power of e, 2.718: use std::exp2(x)", std::exp(x)},
      {"this is a power of 10: use std::exp2(x)", std::pow(10, x)},
      {"std::pow takes the base first: std::pow(2, x), or std::exp2(x)", x * x},
      {"136 is subtracted from the exponent, before the power: std::exp2(exponent - 136)",
       std::exp2(k) - 136},
      {"a power of 2 below 1 is 0 as an int: keep it in a double", std::floor(right)},
      {"the exponent is not used: the brightest light is 1, as in a PNG file",
       {1 / 255., 1 / 256.}},
      {"the exponent is not used: multiply by 2 to the power k - 136", 1},
  };
}

/// Channels as many compute them.
Slips<double> wrong_channels(int m, int k) {
  const double power = std::exp2(k - 136);
  const double right = light_of(m, k);
  const bool dark = m == 0;
  Slips<double> wrong;
  // With the right factor, without the half, and with the half also where the byte is 0.
  for (const double half : {0.5, 0.0}) {
    wrong += changed(wrong_powers(k), [=](double other) { return dark ? 0 : (m + half) * other; });
    wrong += changed(wrong_powers(k), [=](double other) { return (m + half) * other; });
  }
  /// Also where the byte is 0, and not.
  const auto any = [=](double light) { return std::vector{light, dark ? 0 : light}; };
  wrong += {
      {"the half is missing: the file's writer cuts m off, and m + 1/2 is the middle", m * power},
      {"* comes before +: write (m + 0.5) * the power", any(m * power + 0.5)},
      {"* comes before +: write (m + 0.5) * the power", any(m + 0.5 * power)},
      {"the base of the power is 2, not m + 1/2: multiply that by std::exp2(exponent - 136)",
       any(std::pow(m + 0.5, k - 136))},
      {"it is m + 1/2: the middle between m and m + 1", any((m - 0.5) * power)},
      {"it is m + 1/2: the middle between m and m + 1", any((m + 1) * power)},
      {"light may be far above 1, as the sun's is: do not limit it",
       {std::min(right, 1.), std::min((m + 0.5) * power, 1.), std::min(m * power, 1.)}},
      {"the light of a channel is no whole number: keep it in a double", std::floor(right)},
      {"the exponent is not used, and the bytes of this file are light: leave srgb_decode out",
       srgb_decode(m / 255.0)},
      {"the numbers of this file are light: leave srgb_decode out", srgb_decode(right)},
      {"the picture's program encodes the light: leave srgb_encode out", srgb_encode(right)},
  };
  return wrong;
}

Slips<Light> wrong_lights(int red, int green, int blue, int k) {
  const double power = std::exp2(k - 136);
  const auto light = [=](int r, int g, int b) { return light_of_bytes(r, g, b, k); };
  const Light right = light(red, green, blue);
  const Light halves{(red + 0.5) * power, (green + 0.5) * power, (blue + 0.5) * power};
  Slips<Light> wrong = combined(
      [](double r, double g, double b) {
        return Light{r, g, b};
      },
      wrong_channels(red, k), wrong_channels(green, k), wrong_channels(blue, k));
  for (int guarded = 0; guarded < 7; ++guarded) {  // a bit for each channel where 0 is no light
    wrong += {{"a byte 0 has no light: here the half must not be added",
               {(guarded & 1) != 0 ? right.r : halves.r, (guarded & 2) != 0 ? right.g : halves.g,
                (guarded & 4) != 0 ? right.b : halves.b}}};
  }
  wrong += {
      {"red and blue are exchanged (BGR in place of RGB)", light(blue, green, red)},
      {"two channels come from the same byte: look for a line that was copied",
       {light(red, red, blue), light(red, green, green), light(red, green, red)}},
      {"all channels come from red: the texel is gray", light(red, red, red)},
      {"each channel has its own byte: one that is 0 leaves the others as they are",
       {red == 0 || green == 0 || blue == 0 ? Light{} : right, red == 0 ? Light{} : right,
        red == 0 ? Light{} : halves}},
  };
  return wrong;
}

Exercise light_from_four_bytes() {
  Law<Light(int, int, int, int)> law{
      .right = light_of_bytes,
      .places = {{"with the exponent 136 a byte m means m + 1/2", {200, 100, 50, 136}},
                 {"a byte 0 has no light", {200, 0, 0, 136}},
                 {"a byte 0 in red alone: the others have their light", {0, 120, 60, 132}},
                 {"one less in the exponent is half of the light", {200, 100, 50, 135}},
                 {"a gray of about 1/2: the byte 127 with the exponent 128", {127, 127, 127, 128}},
                 {"the sun: the exponent 138", {225, 195, 147, 138}},
                 {"a very dark blue", {130, 140, 160, 120}}},
      .slips = wrong_lights};
  return exercise("12.1", "Color light_of_texel(int red, int green, int blue, int exponent)",
                  std::move(law), light_of_texel, without_noise);
}

/// Edges of a row as many compute them, with the lower edge of row + 1.
Slips<double> wrong_edges(double row, double height) {
  return {
      {"std::cos takes radians: the polar angle runs to pi, not to 180",
       {180 * row / height, std::floor(180 * row / height)}},
      {"the turn around the axis is 2 pi, the polar angle only pi: you use 2 pi for both",
       2 * pi * row / height},
      {"the polar angle runs from 0 to pi: yours ends at the equator", pi / 2 * row / height},
      {"row / height divides whole numbers, and the rest is lost: write pi * row / height",
       {pi * std::floor(row / height), std::floor(row / height)}},
      {"pi is missing: the polar angle of an edge is pi * row / height", row / height},
      {"an edge is row times pi / height, not row alone", row},
      {"your edges are one row too far down: row 0 begins at the polar angle 0",
       pi * (row + 1) / height},
      {"your edges are one row too far up: row 0 begins at the polar angle 0",
       pi * (row - 1) / height},
      {"row 0 begins at the polar angle 0: leave the half out",
       {pi * (row - 0.5) / height, pi * (row + 0.5) / height}},
      {"there are height rows, and the last one ends at pi: divide by height, not by height - 1",
       pi * row / (height - 1)},
  };
}

Slips<double> wrong_solid_angles(int row_number, int width_in_texels, int height_in_texels) {
  const double row = row_number;
  const double width = width_in_texels;
  const double height = height_in_texels;
  const double a = pi * row / height;
  const double b = pi * (row + 1) / height;
  const double cosines = std::cos(a) - std::cos(b);
  const double part = 2 * pi / width;  // of the turn around the axis
  const double in_width = std::cos(pi * row / width) - std::cos(pi * (row + 1) / width);
  /// Instead of the integral, with several factors.
  const auto sine = [=](double s) {
    return std::vector{part * pi / height * s, part * 2 / height * s, part / height * s,
                       part * pi / 2 / height * s, part * s};
  };
  /// Instead of the lower edge.
  const auto lower = [=](std::vector<double> edges) {
    for (double& edge : edges) edge = part * (std::cos(a) - std::cos(edge));
    return edges;
  };
  /// Instead of 2 pi / width, and with cos b - cos a.
  const auto factor = [=](std::vector<double> factors) {
    for (const double f : std::vector(factors)) factors.push_back(-f);
    for (double& f : factors) f *= cosines;
    return factors;
  };
  Slips<double> wrong = {
      {"the sine is missing: texels at the poles count as much as those at the equator",
       part * pi / height},
      {"all texels have the same part of 4 pi: on the picture, but not on the sphere",
       part * 2 / height},
      {"cos a - cos b, not cos b - cos a: a solid angle is above 0", -part * cosines},
      {"the cosines are subtracted, not added: the integral is cos a - cos b",
       part * (std::cos(a) + std::cos(b))},
      {"the cosines are subtracted, not multiplied: the integral is cos a - cos b",
       part * (std::cos(a) * std::cos(b))},
      {"the integral is cos a - cos b, not the cosine of a - b",
       {part * std::cos(a - b), part * (1 - std::cos(a - b))}},
      {"take cos a - cos b, with angles from the pole: yours are sines, or angles from the equator",
       {part * (std::sin(a) - std::sin(b)), part * (std::sin(b) - std::sin(a))}},
      {"this is all from the north pole down to b: it is cos a - cos b, not 1 - cos b",
       part * (1 - std::cos(b))},
      {"this is all from the north pole down to a: it is cos a - cos b, not 1 - cos a",
       part * (1 - std::cos(a))},
      {"cos b is missing: the integral is cos a - cos b", part * std::cos(a)},
      {"* comes before -: put brackets around cos a - cos b", part * std::cos(a) - std::cos(b)},
      {"width and height are exchanged: rows divide the polar angle by the height",
       2 * pi / height * in_width},
      {"the polar angle is divided by the height: you divide it by the width", part * in_width},
      {"this is the sine in the middle of the row: close, but use the integral, cos a - cos b",
       sine(std::sin(pi * (row + 0.5) / height))},
      {"this is the sine at the row's upper edge: the first row vanishes. Use cos a - cos b",
       sine(std::sin(a))},
      {"this is the sine at the row's lower edge: the last row vanishes. Use cos a - cos b",
       sine(std::sin(b))},
      {"this is the mean of two sines: close, but use the integral, cos a - cos b",
       sine((std::sin(a) + std::sin(b)) / 2)},
  };
  const Slips<double> upper_edges = wrong_edges(row, height);
  const Slips<double> lower_edges = wrong_edges(row + 1, height);
  wrong += combined(
      [=](double upper, double below) { return part * (std::cos(upper) - std::cos(below)); },
      upper_edges, lower_edges);
  wrong += {
      {"the lower edge needs brackets: it is pi * (row + 1) / height, the edge of the next row",
       lower({pi * row + 1 / height, pi * row, pi * row + 1, (pi * row + 1) / height, a + 1,
              pi * (row / height + 1), pi * (row + 1 / height), row + pi / height})},
      {"both edges are the same: the lower edge is that of row + 1", lower({a})},
      {"the lower edge is that of row + 1: yours is that of row - 1",
       lower({pi * (row - 1) / height})},
      {"the lower edge is that of row + 1: with pi it is the south pole", lower({pi})},
      {"this is the solid angle of the whole row: divide by the width", factor({2 * pi})},
      {"the turn around the axis is 2 pi, not pi: all texels together have only half of 4 pi",
       factor({pi / width})},
      {"the turn around the axis is 2 pi, not 4 pi: all texels together have twice 4 pi",
       factor({4 * pi / width})},
      {"2 pi is missing: a texel covers 2 pi / width of the turn", factor({1 / width})},
      {"multiply by 2 pi / width: a texel is only a part of the turn around the axis", factor({1})},
      {"std::cos takes radians, and so does the turn around the axis: it is 2 pi, not 360",
       factor({360 / width})},
      {"cos a - cos b has the row's height in it: leave out the other height",
       factor({part * pi / height, part / height, part * 2 / height})},
      {"divide 2 pi by the width: you multiply", factor({2 * pi * width})},
      {"the width divides the turn, and the height the polar angle: you divide by the height here",
       factor({2 * pi / height})},
  };
  return wrong;
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
      .slips = wrong_solid_angles};
  return exercise("12.2", "double solid_angle(int row, int width, int height)", std::move(law),
                  solid_angle, without_noise);
}

int right_thing(const Sums& sums, double r) {
  const auto above = std::upper_bound(sums.begin(), sums.end() - 1, r);
  return static_cast<int>(above - sums.begin());
}

Slips<int> wrong_things(const Sums& sums, double r) {
  const auto size = static_cast<int>(sums.size());
  const int last = size - 1;
  const auto above =  // size if there is none
      static_cast<int>(std::upper_bound(sums.begin(), sums.end(), r) - sums.begin());
  const int right = std::min(above, last);
  const auto nearer = [=](double a, double b) { return std::abs(a - r) < std::abs(b - r); };
  const auto nearest = std::min_element(sums.begin(), sums.end(), nearer) - sums.begin();
  /// The first i that fits, or what many return if none does.
  const auto first = [&](const auto& fits, std::vector<int> otherwise) {
    for (int i = size; i-- > 0;) {
      const auto at = static_cast<std::size_t>(i);
      if (fits(i, sums[at], i == 0 ? 0 : sums[at - 1]))
        std::fill(otherwise.begin(), otherwise.end(), i);
    }
    return otherwise;
  };
  const auto from_above = [=](int, double sum, double) { return r < sum; };
  const auto not_below = [=](int, double sum, double) { return r <= sum; };
  const std::vector<int> but_first{last, size, -1};  // where that is another mistake
  const std::vector<int> all{last, size, -1, 0};
  return {
      {"the sums are not used: all things are equally likely, the sun as much as a cloud",
       {static_cast<int>(r * size), static_cast<int>(r * last),
        static_cast<int>(std::lround(r * last))}},
      {"your index is one too large: you draw the thing after the right one",
       {above + 1, right + 1, std::min(above + 1, last)}},
      {"your index is one too small: you draw the thing before the right one",
       {std::max(right - 1, 0), std::max(above - 1, 0), right - 1, above - 1}},
      {"nothing is left if r is not below the last sum: limit the index to the last thing", above},
      {"if rounding left no sum above r, return the last thing, not -1", first(from_above, {-1})},
      {"if rounding left no sum above r, return the last thing, not the first",
       first(from_above, {0})},
      {"r < sums[i], not r <= sums[i]: a thing with the probability 0 is drawn",
       first(not_below, {last})},
      {"r < sums[i], not r <= sums[i], and limit the index to the last thing",
       first(not_below, {size})},
      {"r < sums[i], not r <= sums[i], and return the last thing if there is no such i",
       first(not_below, {-1, 0})},
      {"the comparison is turned around: find the first i with r < sums[i]",
       first([=](int, double sum, double) { return r > sum; }, but_first)},
      {"the comparison is turned around: find the first i with r < sums[i]",
       first([=](int, double sum, double) { return r >= sum; }, but_first)},
      {"r is hardly ever equal to a sum: find the first i with r < sums[i]",
       first([=](int, double sum, double) { return r == sum; }, all)},
      {"thing 0 is never drawn: begin with i = 0",
       first([=](int i, double sum, double) { return i > 0 && r < sum; }, all)},
      {"thing 0 is left out: it is drawn where r is below sums[0], with no sum before it",
       first([=](int i, double sum, double before) { return i > 0 && r >= before && r < sum; },
             but_first)},
      {"r may be equal to the sum before: write >= there, or leave that comparison out",
       first([=](int, double sum, double before) { return r > before && r < sum; }, all)},
      {"compare r with sums[i]: you compare it with the probability of thing i alone",
       first([=](int, double sum, double before) { return r < sum - before; }, all)},
      {"sums[i] is a sum already: do not add the sums up, and subtract none from r",
       first([&](int i, double,
                 double) { return r < std::accumulate(sums.begin(), sums.begin() + i + 1, 0.0); },
             all)},
      {"r draws the first sum above it: yours is compared with 1 - r",
       first([=](int, double sum, double) { return 1 - r < sum; }, all)},
      {"the last thing is never drawn: limit the index to sums.size() - 1",
       std::min(above, last - 1)},
      {"you always draw the last thing: begin at the first, and stop where r < sums[i]", last},
      {"you always draw the first thing: go on while r is not below sums[i]", 0},
      {"your search goes on to the last thing: stop at the first i with r < sums[i]",
       {r < sums.back() ? last : 0, r < sums.back() ? last : -1}},
      {"you count the sums above r: count those that are not above it, up to the last thing",
       size - above},
      {"take the first sum above r, not the one nearest to r", static_cast<int>(nearest)},
  };
}

Exercise draw_one_of_many() {
  const Sums three{0.5, 0.5, 1}, sun{0.1, 0.2, 0.9, 1}, dark{0, 0.25, 1}, rounded{0.4, 0.8, 0.999};
  Law<int(const Sums&, double)> law{
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
      .slips = wrong_things};
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
      {light_from_four_bytes(), angle_of_a_texel(), draw_one_of_many()},
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
