// The exercises of chapter 12. The lesson's SkyOptions and SkyLight are here structs that call the
// student's functions: when the sky is loaded, and when a direction is drawn.
#include <numeric>

#include "engine/draw/develop.hpp"
#include "engine/draw/gather.hpp"
#include "engine/run/sampling_options.hpp"
#include "engine/run/sky_options.hpp"
#include "exercises.hpp"
#include "math/srgb.hpp"
#include "sampling/directions.hpp"
#include "texture/sky_texels.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::chapter_12 {

using Sums = std::vector<double>;
static std::function<Rgb(int, int, int, int)> light_of_texel;
static std::function<double(int, int, int)> solid_angle;
static std::function<int(const Sums&, double)> drawn_thing;

/// A picture of the sky as the student reads its texels, each first written as in a .hdr file.
inline LightImage read_by_student(LightImage map) {
  for (Color<float>& texel : map.pixels) {
    const auto brightest = static_cast<double>(std::max({texel.r, texel.g, texel.b}));
    const int k = brightest > 0 ? std::ilogb(brightest) + 129 : 0;
    const auto byte = [k](float light) {
      return static_cast<int>(std::ldexp(double(light), 136 - k));
    };
    texel = number_cast<float>(light_of_texel(byte(texel.r), byte(texel.g), byte(texel.b), k));
  }
  return map;
}

/// The same picture, brighter where the student takes a texel for larger than it is: its sums over
/// all directions are then the student's.
inline LightImage weighted_by_student(LightImage map) {
  for (int row = 0; row < map.height; ++row) {
    const double weight =
        solid_angle(row, map.width, map.height) / SkyBand(row, map.width, map.height).solid_angle;
    for (int column = 0; column < map.width; ++column)
      map.at(column, row) = map.at(column, row) * static_cast<float>(weight);
  }
  return map;
}

struct SkyLight : texmap::SkyLight {
  Sums row_sums;                 ///< of the probabilities of all rows
  std::vector<Sums> texel_sums;  ///< of those of a row's texels, if it is drawn

  SkyLight() = default;
  explicit SkyLight(texmap::SkyLight sky) : texmap::SkyLight(std::move(sky)) {
    const Environment& loaded = picture;
    if (light_of_texel) {
      picture = Environment(read_by_student(loaded.map()), loaded.filter());
      moments = SkyMoments(picture);
    }
    if (solid_angle) moments = SkyMoments(Environment(weighted_by_student(loaded.map())));
    const auto width = static_cast<std::ptrdiff_t>(picture.map().width);
    const Sums drawn(above_mean.probabilities().begin(), above_mean.probabilities().end());
    for (auto p = drawn.begin(); p != drawn.end(); p += width) {
      Sums& sums = texel_sums.emplace_back(width);
      std::partial_sum(p, p + width, sums.begin());
      const double row = sums.back();
      for (double& sum : sums) sum = row > 0 ? sum / row : 0;
      row_sums.push_back(row_sums.empty() ? row : row_sums.back() + row);
    }
  }

  SkyDirection<double> draw(bool /*mis*/, const Point2<double>& sample) const {
    const int row = one_of(row_sums, sample.v);
    const int column = one_of(texel_sums[static_cast<std::size_t>(row)], sample.u);
    const Uv<double> uv = {(column + 0.5) / picture.map().width,
                           1 - (row + 0.5) / picture.map().height};
    return {picture.from_map(direction_rtiow(uv)), uv};
  }
  /// What the student draws; the first if there is no such thing.
  static int one_of(const Sums& sums, double r) {
    const int thing = drawn_thing(sums, r);
    return thing >= 0 && thing < static_cast<int>(sums.size()) ? thing : 0;
  }
};

struct SkyStage {
  Camera camera{};
  SkyLight sky{};
};

struct SkyOptions : texmap::SkyOptions {
  [[nodiscard]] SkyLight load(const Chosen& user) {
    return SkyLight(texmap::SkyOptions::load(user));
  }
};

}  // namespace texmap::chapter_12

#include "12_environment_map/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_12;

/// The sky's picture by as many samples a pixel.
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
Rgb light_of_bytes(int red, int green, int blue, int k) {
  return {light_of(red, k), light_of(green, k), light_of(blue, k)};
}

/// Powers of 2 as many write them.
Slips<double> wrong_powers(int k) {
  const double x = k - 136.0, p = exp2(x);
  return {
      {"the exponent is k - 136, because m has 8 bits: do not divide m by 255 or 256, too",
       {p * 256, p * 2, p / 2, p / 255, p / 256, p * 256 / 255}},
      {"the exponent has the wrong sign: it is k - 136, and a larger k is more light", 1 / p},
      {"a power of 2 is std::exp2(k - 136)",
       {{"2 ^ x is no power in C++ (it compares bits)", 1.0 * (2 ^ (k - 136))},
        // What today's processors do: they take the lowest five bits.
        {"1 << x shifts by no number below 0, and a dark texel has one",
         1.0 * static_cast<int>(1U << (static_cast<unsigned>(k - 136) & 31U))},
        {"std::exp is a power of e, and std::pow takes the base first", {exp(x), x * x}},
        {"136 is subtracted before the power", exp2(k) - 136},
        {"a power below 1 is 0 as an int", floor(p)},
        {"the exponent is not used, as in a PNG file", {1. / 255, 1. / 256, 1}},
        {"", {x, 2 * x, pow(10, x)}}}},
  };
}

/// Channels as many compute them.
Slips<double> wrong_channels(int m, int k) {
  const double power = exp2(k - 136), right = light_of(m, k);
  const auto by = [&](double number) {
    return changed(wrong_powers(k), [=](double other) { return number * other; });
  };
  const Slips<double> lights = {
      by(m + 0.5),
      by(m),
      {"* comes before +: write (m + 0.5) * the power", {m * power + 0.5, m + 0.5 * power}},
      {"the base of the power is 2, not m + 1/2", pow(m + 0.5, k - 136)},
      {"it is m + 1/2: the middle between m and m + 1", {(m - 0.5) * power, (m + 1) * power}},
  };
  return {
      // Also where the byte is 0, and not.
      changed(lights, [=](double light) { return m == 0 ? 0 : light; }),
      lights,
      {"the half is missing: the file's writer cuts m off, and m + 1/2 is the middle", m * power},
      {"light is no whole number and may be far above 1, as the sun's is: do not limit it",
       {min(right, 1.), min((m + 0.5) * power, 1.), min(m * power, 1.), floor(right)}},
      {"the numbers of this file are light: leave srgb_decode and srgb_encode out",
       {srgb_decode(m / 255.0), srgb_decode(right), srgb_encode(right)}},
  };
}

Slips<Rgb> wrong_lights(int red, int green, int blue, int k) {
  const double power = exp2(k - 136);
  const auto color = [](double r, double g, double b) { return Rgb{r, g, b}; };
  const Rgb right = light_of_bytes(red, green, blue, k);
  const Rgb halves{(red + 0.5) * power, (green + 0.5) * power, (blue + 0.5) * power};
  Slips<Rgb> wrong = {
      combined(color, wrong_channels(red, k), wrong_channels(green, k), wrong_channels(blue, k)),
      {"all channels come from red: the texel is gray", gray(right.r)},
      {"each channel has its own byte: one that is 0 leaves the others as they are",
       {red * green * blue == 0 ? Rgb{} : right, red == 0 ? Rgb{} : right,
        red == 0 ? Rgb{} : halves}},
  };
  for (int guarded = 0; guarded < 7; ++guarded) {  // a bit for each channel where 0 is no light
    wrong += {"a byte 0 has no light: here the half must not be added",
              Rgb{(guarded & 1) != 0 ? right.r : halves.r, (guarded & 2) != 0 ? right.g : halves.g,
                  (guarded & 4) != 0 ? right.b : halves.b}};
  }
  return wrong;
}

constexpr Place<int, int, int, int> light_of_texel_places[] = {
    {"with the exponent 136 a byte m means m + 1/2", {200, 100, 50, 136}},
    {"a byte 0 has no light", {200, 0, 0, 136}},
    {"a byte 0 in red alone: the others have their light", {0, 120, 60, 132}},
    {"one less in the exponent is half of the light", {200, 100, 50, 135}},
    {"a gray of about 1/2: the byte 127 with the exponent 128", {127, 127, 127, 128}},
    {"the sun: the exponent 138", {225, 195, 147, 138}},
    {"a very dark blue", {130, 140, 160, 120}},
};

/// Edges of a row as many compute them, with the lower edge of row + 1.
Slips<double> wrong_edges(double i, double h) {
  return {"the polar angle of an edge is pi * row / height",
          {{"std::cos takes radians", {180 * i / h, floor(180 * i / h)}},
           {"row / height divides whole numbers", {pi * floor(i / h), floor(i / h)}},
           {"leave the half out", {pi * (i - 0.5) / h, pi * (i + 0.5) / h}},
           {"divide by height, not by height - 1", pi * i / (h - 1)},
           {"pi is missing", {i / h, i}},
           {"your rows run over 2 pi or half of pi", {2 * pi * i / h, pi / 2 * i / h}},
           {"yours is that of another row", {pi * (i + 1) / h, pi * (i - 1) / h}}}};
}

Slips<double> wrong_solid_angles(double row, double w, double h) {
  const double a = pi * row / h, b = pi * (row + 1) / h;
  const double ca = cos(a), cb = cos(b), sa = sin(a), sb = sin(b);
  const double cosines = ca - cb, part = 2 * pi / w;  // of the turn around the axis
  const double in_width = cos(pi * row / w) - cos(pi * (row + 1) / w);
  // What many take for the integral; below, also the sine times a height of the row.
  const Slips<double> integrals = {
      {"the integral is cos a - cos b",
       {{"yours is cos b - cos a, and a solid angle is above 0", -cosines},
        {"yours are sines, or angles from the equator", {sa - sb, sb - sa}},
        {"yours reaches from the north pole to an edge", {1 - cb, 1 - ca}},
        {"", {ca + cb, ca * cb, cos(a - b), 1 - cos(a - b), ca}}}},
      {"the polar angle is divided by the height: you divide it by the width", in_width},
  };
  const Slips<double> sines = {
      "this is the sine at an edge of the row or in its middle: use the integral, cos a - cos b",
      {sin(pi * (row + 0.5) / h), sa, sb, (sa + sb) / 2}};
  const Slips<double> lower_edges = {
      "the lower edge is that of row + 1, pi * (row + 1) / height",
      {pi * row + 1 / h, pi * row, pi * row + 1, (pi * row + 1) / h, a + 1, pi * (row / h + 1),
       pi * (row + 1 / h), row + pi / h, a, pi * (row - 1) / h, pi}};
  const Slips<double> parts = {
      {"a texel covers 2 pi / width, in radians, of the turn around the axis",
       {2 * pi, pi / w, 2 * part, 1 / w, 1, 360 / w, 2 * pi * w, 2 * pi / h}},
      {"cos a - cos b has the height in it already", {part * pi / h, part / h, part * 2 / h}},
  };
  Slips<double> wrong = {
      {"the sine is missing: texels at the poles count as at the equator", part * pi / h},
      {"all texels have the same part of 4 pi: not on the sphere", part * 2 / h},
      {"* comes before -: put brackets around cos a - cos b", part * cos(a) - cos(b)},
      {"width and height are exchanged: rows divide the polar angle", 2 * pi / h * in_width},
      {"std::cos takes radians, and so does the turn around the axis: pi is 180 degrees",
       360 / w * (cos(180 * row / h) - cos(180 * (row + 1) / h))},
      combined([=](double upper, double below) { return part * (cos(upper) - cos(below)); },
               wrong_edges(row, h), wrong_edges(row + 1, h)),
      changed(lower_edges, [=](double edge) { return part * (cos(a) - cos(edge)); }),
  };
  const auto times = [](double factor) { return [=](double value) { return value * factor; }; };
  wrong += changed(integrals, times(part));
  for (const double height : {pi / h, 2 / h, 1 / h, pi / 2 / h, 1.})
    wrong += changed(sines, times(part * height));
  for (const double sign : {1, -1}) wrong += changed(parts, times(sign * cosines));
  return wrong;
}

double right_angle(int row, int w, int h) { return SkyBand(row, w, h).solid_angle; }
constexpr Place<int, int, int> solid_angle_places[] = {
    {"two rows of one texel: each is half of the sphere, 2 pi", {0, 1, 2}},
    {"the lower half is as large", {1, 1, 2}},
    {"8 texels in each of two rows: pi / 4", {0, 8, 2}},
    {"of 4 rows the first ends at 45 degrees: a narrow texel", {0, 8, 4}},
    {"of 4 rows the second reaches from 45 degrees to the equator", {1, 8, 4}},
    {"the last of 4 rows is as large as the first", {3, 8, 4}},
    {"the first row of the chapter's sky", {0, 384, 192}},
    {"its row at the equator", {96, 384, 192}},
};

Slips<int> wrong_things(const Sums& sums, double r) {
  const auto size = static_cast<int>(sums.size());
  const int last = size - 1;
  const auto found = std::upper_bound(sums.begin(), sums.end(), r);
  const auto above = static_cast<int>(found - sums.begin());  // size if there is none
  const int right = min(above, last);
  const auto nearer = [=](double a, double b) { return abs(a - r) < abs(b - r); };
  const auto nearest = std::min_element(sums.begin(), sums.end(), nearer) - sums.begin();
  const auto sum = [&](int i) { return i < 0 ? 0 : sums[static_cast<std::size_t>(i)]; };
  /// The first i that fits, or what many return if none does.
  const auto first = [&](const auto& fits, const std::vector<int>& otherwise) {
    for (int i = 0; i < size; ++i)
      if (fits(i)) return std::vector(otherwise.size(), i);
    return otherwise;
  };
  const auto is_above = [=](int i) { return r < sum(i); };
  const auto not_below = [=](int i) { return r <= sum(i); };
  const std::vector<int> but_first{last, size, -1};  // where that is another mistake
  const std::vector<int> all{last, size, -1, 0};
  return {
      {"the sums are not used: all things are equally likely, the sun as much as a cloud",
       {cut_off(r * size), cut_off(r * last), rounded(r * last)}},
      {"nothing is left if r is not below the last sum: limit the index to the last thing", above},
      {"if rounding left no sum above r, return the last thing", first(is_above, {-1, 0})},
      {"r < sums[i], not r <= sums[i]: else probability 0 is drawn", first(not_below, {last})},
      {"r < sums[i], not r <= sums[i], and return the last thing if there is no such i",
       first(not_below, {size, -1, 0})},
      {"find the first i with r < sums[i]",
       {{"yours is one too large", {above + 1, right + 1, min(above + 1, last)}},
        {"yours is one too small", {max(right - 1, 0), max(above - 1, 0), right - 1, above - 1}},
        {"the comparison is turned around", first([=](int i) { return r > sum(i); }, but_first)},
        {"the comparison is turned around", first([=](int i) { return r >= sum(i); }, but_first)},
        {"r is hardly ever equal to a sum", first([=](int i) { return r == sum(i); }, all)},
        {"thing 0 is never drawn", first([=](int i) { return i > 0 && r < sum(i); }, all)},
        {"thing 0 has no sum before it",
         first([=](int i) { return i > 0 && r >= sum(i - 1) && r < sum(i); }, but_first)},
        {"r may be the sum before",
         first([=](int i) { return r > sum(i - 1) && r < sum(i); }, all)},
        {"you compare r with the probability of thing i alone",
         first([=](int i) { return r < sum(i) - sum(i - 1); }, all)},
        {"you add the sums up, or subtract them from r",
         first([&](int i) { return r < std::accumulate(&sums[0], &sums[0] + i + 1, 0.); }, all)},
        {"yours is compared with 1 - r", first([=](int i) { return 1 - r < sum(i); }, all)},
        {"you always draw the first or the last thing", {0, last}},
        {"your search goes on", {r < sums.back() ? last : 0, r < sums.back() ? last : -1}},
        {"you count the sums above r", size - above},
        {"yours is the sum nearest to r", static_cast<int>(nearest)}}},
      {"the last thing is never drawn: limit the index to sums.size() - 1", min(above, last - 1)},
  };
}

/// Of a million directions drawn by the cosine on a surface that faces the sun, how many find it.
double directions_to_the_sun() {
  const Vec3d to_sun{0, 0, 1};
  int found = 0;
  for (int i = 0; i < 1000 * 1000; ++i) {  // a spiral: a grid gives 24 x 24
    const Point2<double> place{(i + 0.5) / 1e6, fraction(i * std::numbers::phi)};
    if (dot(cosine_direction(to_sun, place), to_sun) > cos(1.4 * radian)) ++found;
  }
  return found;
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const Place<Sums, double> drawn_thing_places[] = {
      {"of the sums 0.1, 0.2, 0.9, 1 the number 0.05 draws thing 0", {{0.1, 0.2, 0.9, 1}, 0.05}},
      {"0.15 draws thing 1", {{0.1, 0.2, 0.9, 1}, 0.15}},
      {"0.5 draws thing 2: its probability is 0.7", {{0.1, 0.2, 0.9, 1}, 0.5}},
      {"0.95 draws the last thing, 3", {{0.1, 0.2, 0.9, 1}, 0.95}},
      {"of 0.02, 0.04, 0.06, 0.08, 1 the 0.07 draws thing 3", {{0.02, 0.04, 0.06, 0.08, 1}, 0.07}},
      {"of 0.25, 0.5, 1 the number 0.5 draws thing 2: 1 ends below it", {{0.25, 0.5, 1}, 0.5}},
      {"of 0.5, 0.5, 1 the number 0.5 draws thing 2: thing 1 has nothing", {{0.5, 0.5, 1}, 0.5}},
      {"of 0, 0.25, 1 the number 0 draws thing 1: thing 0 has nothing", {{0, 0.25, 1}, 0}},
      {"of 0.4, 0.8, 0.999 the number 0.9995 draws the last, 2", {{0.4, 0.8, 0.999}, 0.9995}},
  };
  static const ExercisesOfChapter chapter{
      "12",
      {exercise(light_of_texel, without_noise,
                {light_of_bytes, wrong_lights, light_of_texel_places}),
       exercise(solid_angle, without_noise, {right_angle, wrong_solid_angles, solid_angle_places}),
       exercise(drawn_thing, [] { return scene("importance", 2); },
                {[](const Sums& sums, double r) {
                   return static_cast<int>(std::upper_bound(sums.begin(), sums.end() - 1, r) -
                                           sums.begin());
                 },
                 wrong_things,
                 drawn_thing_places,
                 {},
                 [](const Sums& sums, double /*r*/) { return static_cast<int>(sums.size()); }})},
      {{"The bright core of the sun is 2.8 degrees wide. Of a million directions drawn by the "
        "cosine on a surface that faces the sun, how many find it?",
        directions_to_the_sun,
        {"directions", 0.1},
        "Which solid angle has a disk with the radius 1.4 degrees, and what is the density there?",
        {{298,
          "this is for directions that are equally likely: drawn by the cosine, twice as many are "
          "straight ahead"},
         {2386, "2.8 degrees is the width: the radius is half of it"},
         {1875, "this is the solid angle: multiply it by the density, 1 / pi"}}},
       {"The sky has 384 x 192 texels. How many times as large, on the sphere, is a texel at the "
        "equator as one at a pole?",
        [] { return SkyBand(96, 384, 192).solid_angle / SkyBand(0, 384, 192).solid_angle; },
        {"times", 0.02},
        "Compare cos a - cos b, from the upper to the lower edge of a row, at the equator and at a "
        "pole.",
        {{61.1,
          "this takes the sine at the lower edge of the row at the pole: it begins with the sine "
          "0"}}}},
  };
  return chapter;
}

}  // namespace texmap::check
