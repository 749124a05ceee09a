// The exercises of chapter 07. The lesson is the chapter's own. What it gets and calls leads to the
// student's function: the numbers of a sample, light_along, and the mean of the samples.
#include <array>
#include <cmath>
#include <numbers>

#include "engine/app/layout_options.hpp"
#include "engine/app/sampling_options.hpp"
#include "engine/render/develop.hpp"
#include "exercises.hpp"
#include "math/srgb.hpp"
#include "sampling/samplers.hpp"
#include "scene/path.hpp"

namespace texmap::check {

static Hook<int(const std::vector<int>&)> mean_byte;
static Hook<Vec3<double>(double, double)> scattered;
static Hook<Uv<double>(int, int, double, double)> place_of_sample;

}  // namespace texmap::check

namespace texmap::chapter_07 {

/// The light along a ray of a scene of one globe, scattered by the student.
inline constexpr struct {
  Color<double> operator()(const auto& objects, const Ray<double>& ray, const auto& sky,
                           int bounces, auto& random) const {
    if (!check::scattered) return texmap::light_along(objects, ray, sky, bounces, random);
    const auto& globe = objects.front();
    const double distance = distance_to(globe.shape, ray);
    if (distance == infinity<double>())
      return sky(Ray<double>{ray.origin, normalize(ray.direction)});
    const Hit<double> hit = hit_at(globe.shape, ray, distance);
    const Point2<double> sample = random.next_2d();
    const Vec3<double> way = check::scattered.yours(sample.u, sample.v);
    const Frame<double> frame = frame_about(hit.normal);
    const Vec3<double> direction = frame.right * way.x + frame.up * way.y + hit.normal * way.z;
    return globe.paint(hit) * sky(Ray<double>{hit.outside, direction});
  }
} light_along;

}  // namespace texmap::chapter_07

#include "07_earth_by_sampling/lesson.hpp"

namespace texmap::check {
namespace {

using Vector = Vec3<double>;
using Place2 = Uv<double>;
using Bytes = std::vector<int>;
using chapter_07::Lesson;

constexpr double pi = std::numbers::pi;
constexpr int cells = 4;  // columns and rows of a pixel's samples
constexpr int all_samples = cells * cells;

/// What the lesson calls a scene.
struct Scene {
  View<> view;
  const std::vector<chapter_07::Object>& objects;
  const GradientSky<>& sky;
};

/// The numbers of one sample; the student says the first two, its place in the pixel.
struct Numbers {
  const Sampler& sampler;
  std::uint32_t pixel;
  int sample;
  std::uint32_t dimension = 0;

  Point2<double> next_2d() {
    const auto random =
        sampler.pair<double>(pixel, static_cast<std::uint32_t>(sample), dimension++);
    if (dimension > 1 || !place_of_sample) return random;
    const Place2 place = place_of_sample.yours(sample, cells, random.u, random.v);
    return {place.u, place.v};
  }
};

/// The byte of a channel's samples.
int mean_of(const Bytes& bytes) {
  double light = 0;
  for (const int byte : bytes) light += srgb_decode(byte / 255.);
  return static_cast<int>(
      std::lround(255 * srgb_encode(light / static_cast<double>(bytes.size()))));
}

/// A pixel from the light of its samples.
Rgb8 shown(const std::vector<Rgb>& samples) {
  const auto channel = [&](double Rgb::*part) {
    double sum = 0;
    Bytes bytes;
    bytes.reserve(samples.size());
    for (const Rgb& light : samples) {
      sum += light.*part;
      if (mean_byte) bytes.push_back(static_cast<int>(byte_of_light(light.*part, Transfer::srgb)));
    }
    if (!mean_byte) {
      const double mean = sum / static_cast<double>(samples.size());
      return static_cast<std::uint8_t>(byte_of_light(mean, Transfer::srgb));
    }
    return static_cast<std::uint8_t>(std::clamp(mean_byte.yours(bytes), 0, 255));
  };
  return {channel(&Rgb::r), channel(&Rgb::g), channel(&Rgb::b)};
}

/// A lesson's picture in 100 x 75 pixels, each drawn as 4 x 4, so that single samples show.
Image magnified(const Lesson& lesson) {
  constexpr int times = 4;
  const Scene scene{view_of(lesson.stage.camera, 100, 75), lesson.objects, lesson.stage.sky};
  const Sampler sampler(SamplerKind::random, all_samples);
  Image image(times * scene.view.width, times * scene.view.height);
  for (int row = 0; row < scene.view.height; ++row) {
    for (int column = 0; column < scene.view.width; ++column) {
      const std::uint32_t pixel =
          hash_pixels<double>(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
      std::vector<Rgb> samples;
      samples.reserve(all_samples);
      for (int sample = 0; sample < all_samples; ++sample) {
        Numbers random{sampler, pixel, sample};
        samples.push_back(lesson(scene, PixelPlace<double>{double(column), double(row)}, random));
      }
      const Rgb8 color = shown(samples);
      for (int i = 0; i < times * times; ++i)
        image.at(times * column + i % times, times * row + i / times) = color;
    }
  }
  return image;
}

/// A white globe, for which only the sky counts.
Lesson white_globe(const std::vector<std::string>& words = {}) {
  auto lesson = prepared<Lesson>(words);
  lesson.objects.front().paint.texture.image = Image(1, 1, {255, 255, 255});
  return lesson;
}

Exercise average_light() {
  const auto mean_by = [](auto&& decode, auto&& encode) {
    return [=](const Bytes& bytes) {
      double sum = 0;
      for (const int byte : bytes) sum += decode(byte);
      return static_cast<int>(std::lround(encode(sum / static_cast<double>(bytes.size()))));
    };
  };
  const auto decode = [](int byte) { return srgb_decode(byte / 255.); };
  const auto encode = [](double light) { return 255 * srgb_encode(light); };
  Law<int(const Bytes&)> law{
      .right = mean_of,
      .places = {{"the mean of one byte is this byte", {Bytes{76}}},
                 {"the mean of equal bytes is this byte", {Bytes{200, 200, 200}}},
                 {"half black and half white sends out half of the light: byte 188",
                  {Bytes{0, 255}}},
                 {"three quarters black", {Bytes{0, 255, 0, 0}}},
                 {"a dark and a bright byte", {Bytes{40, 180}}},
                 {"many bytes", {Bytes{10, 20, 40, 80, 160, 250, 130, 70}}},
                 {"white stays white", {Bytes{255, 255}}}},
      .mistakes =
          {{"this is the mean of the bytes, not of the light: decode each byte, encode the mean",
            mean_by([](int byte) { return byte; }, [](double mean) { return mean; })},
           {"this is the mean of the bytes, not of the light: decode each byte, encode the mean",
            [](const Bytes& bytes) {
              int sum = 0;
              for (const int byte : bytes) sum += byte;
              return sum / static_cast<int>(bytes.size());
            }},
           {"byte / 255 with two whole numbers cuts off and gives 0 or 1: write byte / 255.0",
            mean_by(
                [](int byte) {
                  const int cut_off = byte / 255;
                  return srgb_decode(double(cut_off));
                },
                encode)},
           {"the mean is light and no byte yet: encode it",
            mean_by(decode, [](double light) { return 255 * light; })},
           {"decoding and encoding are exchanged: a byte is encoded",
            mean_by([](int byte) { return srgb_encode(byte / 255.); },
                    [](double mean) { return 255 * srgb_decode(mean); })},
           {"the bytes are not decoded, but their mean is encoded: too bright",
            mean_by([](int byte) { return byte / 255.; }, encode)},
           {"the byte is cut off, not rounded: take std::lround",
            [=](const Bytes& bytes) {
              double sum = 0;
              for (const int byte : bytes) sum += decode(byte);
              return static_cast<int>(encode(sum / static_cast<double>(bytes.size())));
            }}},
      .tolerance = 0};
  return exercise("07.1", "int mean_byte(const std::vector<int>& bytes)", std::move(law), mean_byte,
                  [] {
                    return magnified(prepared<Lesson>({"--defocus", "4", "--focus", "6"}));
                  });
}

Exercise more_light_from_above() {
  const auto by = [](auto&& radius_of, double turn, auto&& height_of) {
    return [=](double a, double b) {
      const double radius = radius_of(a);
      const double angle = turn * b;
      return Vector{radius * std::cos(angle), radius * std::sin(angle), height_of(radius)};
    };
  };
  const auto root = [](double a) { return std::sqrt(a); };
  const auto lifted = [](double radius) { return std::sqrt(1 - radius * radius); };
  const auto whole = [](double a) { return a; };
  Law<Vector(double, double)> law{
      .right = by(root, 2 * pi, lifted),
      .places = {{"a = 0 is the middle of the disk: straight up, along the normal", {0.0, 0.5}},
                 {"a = 1/4 has the radius 1/2; b = 0 is in the direction +x", {0.25, 0.0}},
                 {"b = 1/4 is a quarter turn from there: +y", {0.25, 0.25}},
                 {"b = 1/2 is half a turn: -x", {0.25, 0.5}},
                 {"half of the points have a radius below 0.71", {0.5, 0.75}},
                 {"a = 0.81 has the radius 0.9: close to the surface", {0.81, 0.125}}},
      .mistakes =
          {{"the radius is a: too many directions are near the normal. Equal areas need sqrt(a)",
            by(whole, 2 * pi, lifted)},
           {"the directions cover half of the disk: a whole turn is 2 pi", by(root, pi, lifted)},
           {"b is taken for radians: multiply it by 2 pi", by(root, 1, lifted)},
           {"b is turned into degrees: std::cos and std::sin take radians", by(root, 360, lifted)},
           {"the height needs a root: x x + y y + z z is 1",
            by(root, 2 * pi, [](double radius) { return 1 - radius * radius; })},
           {"the height is 1 - radius, so the point lies below the hemisphere: x x + y y + z z is "
            "1",
            by(root, 2 * pi, [](double radius) { return 1 - radius; })},
           {"the points lie on the disk, not above it: lift them",
            by(root, 2 * pi, [](double) { return 0.; })},
           {"each height is equally likely: then light from the side counts too much",
            [](double a, double b) {
              const double radius = std::sqrt(a * (2 - a));
              return Vector{radius * std::cos(2 * pi * b), radius * std::sin(2 * pi * b), 1 - a};
            }}},
      .tolerance = 1e-6};
  return exercise("07.2", "Vec3 scattered(double a, double b)", std::move(law), scattered, [] {
    auto lesson = white_globe({"--sky", "gradient"});
    lesson.stage.sky = {.below = {0, 0, 0}, .above = {1, 1, 1}};
    return magnified(lesson);
  });
}

Exercise one_sample_in_each_cell() {
  const auto row = [](int i, int n) { return i / n; };
  Law<Place2(int, int, double, double)> law{
      .right =
          [=](int i, int n, double a, double b) {
            return Place2{(i % n + a) / n, (row(i, n) + b) / n};
          },
      .places = {{"of 1 cell, the sample is at (a, b)", {0, 1, 0.25, 0.75}},
                 {"sample 0 of 4 x 4 is in the corner at (0, 0)", {0, 4, 0.5, 0.5}},
                 {"sample 3 is at the end of the first row", {3, 4, 0.5, 0.5}},
                 {"sample 4 begins the second row", {4, 4, 0.5, 0.5}},
                 {"sample 7 of 4 x 4, with a = 0.2 and b = 0.7", {7, 4, 0.2, 0.7}},
                 {"sample 8 of 3 x 3, with a = 0.9 and b = 0.1", {8, 3, 0.9, 0.1}}},
      .mistakes =
          {{"all samples of a cell are at its corner: add a and b",
            [=](int i, int n, double, double) {
              return Place2{(i % n) / double(n), row(i, n) / double(n)};
            }},
           {"all samples are in the middle of their cells: the same grid in every pixel makes "
            "stripes. Add a and b",
            [=](int i, int n, double, double) {
              return Place2{(i % n + 0.5) / n, (row(i, n) + 0.5) / n};
            }},
           {"there is no rule for i: these are random samples",
            [](int, int, double a, double b) {
              return Place2{a, b};
            }},
           {"columns and rows are exchanged: sample 1 is the right neighbor of sample 0",
            [=](int i, int n, double a, double b) {
              return Place2{(row(i, n) + a) / n, (i % n + b) / n};
            }},
           {"you divide by n x n: all samples are in one corner of the pixel",
            [=](int i, int n, double a, double b) {
              return Place2{(i % n + a) / (n * n), (row(i, n) + b) / (n * n)};
            }},
           {"the row is no whole number: divide i by n as int, and the rest is cut off",
            [=](int i, int n, double a, double b) {
              return Place2{(i % n + a) / n, (i / double(n) + b) / n};
            }},
           {"the column grows beyond the pixel: it is the remainder i % n",
            [=](int i, int n, double a, double b) {
              return Place2{(i + a) / n, (row(i, n) + b) / n};
            }},
           {"a and b are not divided by n: the samples leave their cells",
            [=](int i, int n, double a, double b) {
              return Place2{(i % n) / double(n) + a, row(i, n) / double(n) + b};
            }}},
      .tolerance = 1e-9};
  return exercise("07.3", "Uv place_of_sample(int i, int n, double a, double b)", std::move(law),
                  place_of_sample, [] { return magnified(prepared<Lesson>()); });
}

/// Pixels of a white globe's picture that differ from the sky.
double pixels_unlike_sky(const std::vector<std::string>& words) {
  const Image image = magnified(white_globe(words));
  double count = 0;
  for (const Rgb8& pixel : image.pixels) {
    if (pixel != image.at(0, 0)) count += 1;
  }
  return count;
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      .exercises = {average_light(), more_light_from_above(), one_sample_in_each_cell()},
      .questions =
          {{"07.a", "Which byte does a pixel get that is a quarter white, the rest black?",
            [] { return double(byte_of_light(0.25, Transfer::srgb)); }, "", 0},
           {"07.b",
            "Let the globe be white, albedo 1, under the chapter's uniform sky. How many pixels "
            "differ from the sky?",
            [] { return pixels_unlike_sky({}); }, "pixels", 0}},
  };
  return chapter;
}

}  // namespace texmap::check
