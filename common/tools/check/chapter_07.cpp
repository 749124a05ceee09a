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
  const GradientSky& sky;
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

using MeanByte = int(const Bytes&);

/// Means as many compute them, each rounded and cut off.
std::vector<Mistake<MeanByte>> wrong_means() {
  std::vector<Mistake<MeanByte>> mistakes;
  const auto wrong = [&](const char* word, auto&& decode, auto&& encode) {
    for (const bool rounds : {true, false}) {
      mistakes.push_back({word, [=](const Bytes& bytes) {
                            double sum = 0;
                            for (const int byte : bytes) sum += decode(byte);
                            const double value = encode(sum, static_cast<double>(bytes.size()));
                            return static_cast<int>(rounds ? std::round(value) : value);
                          }});
    }
  };
  const auto as_it_is = [](int byte) { return byte; };
  const auto share = [](int byte) { return byte / 255.; };
  const auto decode = [](int byte) { return srgb_decode(byte / 255.); };
  const auto encode = [](double sum, double n) { return 255 * srgb_encode(sum / n); };
  const auto number = [](double sum, double n) { return srgb_encode(sum / n); };
  const char* of_bytes =
      "this is the mean of the bytes, not of the light: decode each byte, encode the mean";
  wrong(of_bytes, as_it_is, [](double sum, double n) { return sum / n; });
  wrong("the byte is cut off, not rounded: take std::lround", decode,
        [=](double sum, double n) { return std::floor(encode(sum, n)); });
  wrong("the byte is cut off, not rounded: take std::lround", decode,
        [](double sum, double n) { return std::floor(255.999 * srgb_encode(sum / n)); });
  wrong(
      "every byte but 255 counts as 0: write byte / 255.0, and add in a double",
      [](int byte) { return byte == 255 ? 1 : 0; }, encode);
  wrong("the mean is light and no byte yet: encode it", decode,
        [](double sum, double n) { return 255 * sum / n; });
  wrong(
      "decoding and encoding are exchanged: a byte is encoded",
      [](int byte) { return srgb_encode(byte / 255.); },
      [](double sum, double n) { return 255 * srgb_decode(sum / n); });
  wrong("the bytes are not decoded, but their mean is encoded: too bright", share, encode);
  wrong("the mean of the bytes is decoded: decode each byte, and encode the mean", share,
        [](double sum, double n) { return 255 * srgb_decode(sum / n); });
  wrong("you decode each byte and the mean again: encode the mean", decode,
        [](double sum, double n) { return 255 * srgb_decode(sum / n); });
  const char* no_byte = "this is a number from 0 to 1: encode the mean, and multiply it by 255";
  wrong(no_byte, decode, number);
  wrong(no_byte, decode, [](double sum, double n) { return sum / n; });
  const char* sum_alone = "the sum is no mean: divide it by bytes.size(), then encode it";
  wrong(sum_alone, decode, [](double sum, double) { return 255 * srgb_encode(sum); });
  wrong(sum_alone, decode, [](double sum, double) { return 255 * sum; });
  wrong(sum_alone, as_it_is, [](double sum, double) { return sum; });
  wrong("the sum is encoded before it is divided: encode the mean", decode,
        [](double sum, double n) { return 255 * srgb_encode(sum) / n; });
  const char* undivided = "srgb_decode takes a number from 0 to 1: give it byte / 255.0";
  const auto decode_number = [](int byte) { return srgb_decode(double(byte)); };
  wrong(undivided, decode_number, encode);
  wrong(undivided, decode_number, number);
  const char* white = "white is byte 255, and there it is 1: divide and multiply by 255, not 256";
  wrong(white, decode, [](double sum, double n) { return 256 * srgb_encode(sum / n); });
  wrong(
      white, [](int byte) { return srgb_decode(byte / 256.); }, encode);
  for (const double power : {2., 2.2}) {
    wrong(
        "the bytes are not encoded by this power alone: take srgb_decode and srgb_encode",
        [=](int byte) { return std::pow(byte / 255., power); },
        [=](double sum, double n) { return 255 * std::pow(sum / n, 1 / power); });
  }
  for (const bool first : {true, false}) {
    mistakes.push_back({"a byte is missing in the sum: all count, from the first to the last",
                        [=](const Bytes& bytes) {
                          Bytes others = bytes;
                          (first ? others.front() : others.back()) = 0;
                          return mean_of(others);
                        }});
  }
  return mistakes;
}

Exercise average_light() {
  Law<MeanByte> law{.right = mean_of,
                    .places = {{"the mean of one byte is this byte", {Bytes{76}}},
                               {"the mean of equal bytes is this byte", {Bytes{200, 200, 200}}},
                               {"half black and half white sends out half of the light: byte 188",
                                {Bytes{0, 255}}},
                               {"three quarters black", {Bytes{0, 255, 0, 0}}},
                               {"two dark bytes, 20 and 40: 31.55, so byte 32", {Bytes{20, 40}}},
                               {"a dark and a bright byte", {Bytes{40, 180}}},
                               {"many bytes", {Bytes{10, 20, 40, 80, 160, 250, 130, 70}}},
                               {"white stays white", {Bytes{255, 255}}}},
                    .mistakes = wrong_means(),
                    .tolerance = 0};
  return exercise("07.1", "int mean_byte(const std::vector<int>& bytes)", std::move(law), mean_byte,
                  [] {
                    return magnified(prepared<Lesson>({"--defocus", "4", "--focus", "6"}));
                  });
}

using Scattered = Vector(double, double);

/// The point of the disk, lifted.
constexpr auto lifted_point = [](auto radius_of, double turn, auto height_of) {
  return [=](double a, double b) {
    const double radius = radius_of(a);
    const double angle = turn * b;
    return Vector{radius * std::cos(angle), radius * std::sin(angle), height_of(radius)};
  };
};
double root(double a) { return std::sqrt(a); }
double lifted(double radius) { return std::sqrt(1 - radius * radius); }

/// Wrong points of the disk, at the right height and at two wrong ones.
void add_wrong_points(std::vector<Mistake<Scattered>>& mistakes) {
  const auto wrong = [&](const char* word, auto radius_of, double turn) {
    mistakes.push_back({word, lifted_point(radius_of, turn, lifted)});
    mistakes.push_back(
        {word, lifted_point(radius_of, turn, [](double radius) { return 1 - radius * radius; })});
    mistakes.push_back(
        {word, lifted_point(radius_of, turn, [](double radius) { return 1 - radius; })});
  };
  wrong(
      "the radius is a: too many directions are near the normal. Equal areas need sqrt(a)",
      [](double a) { return a; }, 2 * pi);
  wrong(
      "the radius is a a: equal areas need the root, sqrt(a)", [](double a) { return a * a; },
      2 * pi);
  wrong(
      "the radius is sqrt(1 - a): a = 0 is the middle of the disk, so take sqrt(a)",
      [](double a) { return std::sqrt(1 - a); }, 2 * pi);
  wrong("the directions cover half of the disk: a whole turn is 2 pi", root, pi);
  wrong("b is taken for radians: multiply it by 2 pi", root, 1);
  const char* degrees = "b is turned into degrees: std::cos and std::sin take radians";
  wrong(degrees, root, 360);
  wrong(degrees, root, 360 * 180 / pi);
  wrong("2 pi b is in radians already: no pi / 180 is needed", root, pi * pi / 90);
  wrong("the angle runs the other way: count it from x toward y", root, -2 * pi);
  wrong(
      "all points lie on the edge of the disk: multiply cos and sin by the radius",
      [](double) { return 1.; }, 2 * pi);
}

/// Directions as many make them.
std::vector<Mistake<Scattered>> wrong_scatter() {
  std::vector<Mistake<Scattered>> mistakes;
  const auto wrong = [&](const char* word, std::function<Scattered> function) {
    mistakes.push_back({word, std::move(function)});
  };
  const auto right = lifted_point(root, 2 * pi, lifted);
  add_wrong_points(mistakes);
  wrong("all points lie on the edge of the disk: multiply cos and sin by the radius",
        [=](double a, double b) {
          return Vector{std::cos(2 * pi * b), std::sin(2 * pi * b), right(a, b).z};
        });
  wrong("the height needs a root: x x + y y + z z is 1",
        lifted_point(root, 2 * pi, [](double radius) { return 1 - radius * radius; }));
  wrong("the height is 1 - radius, so the point lies below the hemisphere: x x + y y + z z is 1",
        lifted_point(root, 2 * pi, [](double radius) { return 1 - radius; }));
  const char* square = "the length is not 1: the height is the root of 1 - radius * radius";
  wrong(square, lifted_point(root, 2 * pi, [](double radius) { return std::sqrt(1 - radius); }));
  wrong(square, lifted_point(root, 2 * pi, [](double radius) {
          return std::sqrt(1 - radius * radius * radius * radius);
        }));
  wrong(square,
        lifted_point(root, 2 * pi, [](double radius) { return std::sqrt(1 + radius * radius); }));
  wrong(square, lifted_point(root, 2 * pi, [](double) { return 1.; }));
  wrong(square, lifted_point(root, 2 * pi, [](double radius) { return radius; }));
  wrong(square, [=](double a, double b) {
    const Vector p = right(a, b);
    return Vector{p.x, p.y, std::sqrt(1 - p.x * p.x)};
  });
  wrong(
      "you make the length 1 at the end, and move x and y: the height is sqrt(1 - radius * radius)",
      [=](double a, double b) {
        const Vector p = right(a, b);
        return normalize(Vector{p.x, p.y, 1});
      });
  wrong("the points lie on the disk, not above it: lift them",
        lifted_point(root, 2 * pi, [](double) { return 0.; }));
  wrong("the points lie below the surface: the height is not negative",
        lifted_point(root, 2 * pi, [](double radius) { return -lifted(radius); }));
  wrong("each height is equally likely: then light from the side counts too much",
        [](double a, double b) {
          const double radius = std::sqrt(a * (2 - a));
          return Vector{radius * std::cos(2 * pi * b), radius * std::sin(2 * pi * b), 1 - a};
        });
  wrong("these directions go to all sides, also below the surface: lift a point of the disk",
        [](double a, double b) {
          const double z = 1 - 2 * a;
          const double radius = std::sqrt(1 - z * z);
          return Vector{radius * std::cos(2 * pi * b), radius * std::sin(2 * pi * b), z};
        });
  wrong("a and b are exchanged: a makes the radius, b the angle",
        [=](double a, double b) { return right(b, a); });
  wrong("a makes the radius and the angle: the angle is 2 pi b",
        [=](double a, double) { return right(a, a); });
  wrong("b makes the radius and the angle: the radius is sqrt(a)",
        [=](double, double b) { return right(b, b); });
  wrong("cos and sin are exchanged: the angle is counted from x toward y", [=](double a, double b) {
    const Vector p = right(a, b);
    return Vector{p.y, p.x, p.z};
  });
  wrong("the normal is +z here: the height is z, not y", [=](double a, double b) {
    const Vector p = right(a, b);
    return Vector{p.x, p.z, p.y};
  });
  return mistakes;
}

Exercise more_light_from_above() {
  Law<Scattered> law{
      .right =
          [](double a, double b) {
            const double radius = std::sqrt(a);
            return Vector{radius * std::cos(2 * pi * b), radius * std::sin(2 * pi * b),
                          std::sqrt(1 - radius * radius)};
          },
      .places = {{"a = 0 is the middle of the disk: straight up, along the normal", {0.0, 0.5}},
                 {"a = 1/4 has the radius 1/2; b = 0 is in the direction +x", {0.25, 0.0}},
                 {"b = 1/4 is a quarter turn from there: +y", {0.25, 0.25}},
                 {"b = 1/2 is half a turn: -x", {0.25, 0.5}},
                 {"half of the points have a radius below 0.71", {0.5, 0.75}},
                 {"a = 0.81 has the radius 0.9: close to the surface", {0.81, 0.125}}},
      .mistakes = wrong_scatter(),
      .tolerance = 1e-6};
  return exercise("07.2", "Vec3 scattered(double a, double b)", std::move(law), scattered, [] {
    auto lesson = white_globe({"--sky", "gradient"});
    lesson.stage.sky = {.below = {0, 0, 0}, .above = {1, 1, 1}};
    return magnified(lesson);
  });
}

using PlaceOfSample = Place2(int, int, double, double);

/// A sample's cell, and the random numbers.
struct Cell {
  int i, n;
  double column, row, a, b;
};

Mistake<PlaceOfSample> wrong_place(const char* word, Place2 (*place)(const Cell&)) {
  return {word, [=](int i, int n, double a, double b) {
            return place({i, n, double(i % n), std::floor(double(i) / n), a, b});
          }};
}

/// Samples in the wrong cells.
void add_wrong_cells(std::vector<Mistake<PlaceOfSample>>& mistakes) {
  const auto wrong = [&](const char* word, Place2 (*place)(const Cell&)) {
    mistakes.push_back(wrong_place(word, place));
  };
  wrong("the rows are upside down: v begins at 0 with row 0", [](const Cell& c) {
    return Place2{(c.column + c.a) / c.n, (c.n - 1 - c.row + c.b) / c.n};
  });
  wrong("the rows are upside down: v begins at 0 with row 0", [](const Cell& c) {
    return Place2{(c.column + c.a) / c.n, 1 - (c.row + c.b) / c.n};
  });
  wrong("samples are counted from 0: column i % n and row i / n, without 1", [](const Cell& c) {
    const int i = c.i + 1;
    return Place2{(i % c.n + c.a) / c.n, (std::floor(double(i) / c.n) + c.b) / c.n};
  });
  wrong("samples are counted from 0: column i % n and row i / n, without 1", [](const Cell& c) {
    return Place2{(c.column - 1 + c.a) / c.n, (c.row - 1 + c.b) / c.n};
  });
  wrong("the row is i / n, without the rest: i % n is the column", [](const Cell& c) {
    return Place2{(c.column + c.a) / c.n, (c.column + c.b) / c.n};
  });
  wrong("the column is the remainder i % n: i / n is the row", [](const Cell& c) {
    return Place2{(c.row + c.a) / c.n, (c.row + c.b) / c.n};
  });
  wrong("the row is no whole number: divide i by n as int, and the rest is cut off",
        [](const Cell& c) {
          return Place2{(c.column + c.a) / c.n, (double(c.i) / c.n + c.b) / c.n};
        });
  wrong("the column grows beyond the pixel: it is the remainder i % n", [](const Cell& c) {
    return Place2{(c.i + c.a) / c.n, (c.row + c.b) / c.n};
  });
  wrong("i counts samples, not rows: the row is i / n", [](const Cell& c) {
    return Place2{(c.column + c.a) / c.n, (c.i + c.b) / c.n};
  });
  wrong("i counts samples: the column is i % n, the row is i / n", [](const Cell& c) {
    return Place2{(c.i + c.a) / c.n, (c.i + c.b) / c.n};
  });
}

/// Places of samples as many compute them.
std::vector<Mistake<PlaceOfSample>> wrong_places() {
  std::vector<Mistake<PlaceOfSample>> mistakes;
  const auto wrong = [&](const char* word, Place2 (*place)(const Cell&)) {
    mistakes.push_back(wrong_place(word, place));
  };
  const char* corner = "all samples of a cell are at its corner: add a and b";
  wrong(corner, [](const Cell& c) { return Place2{c.column / c.n, c.row / c.n}; });
  wrong(
      "all samples are in the middle of their cells: the same grid in every pixel makes stripes. "
      "Add a and b",
      [](const Cell& c) {
        return Place2{(c.column + 0.5) / c.n, (c.row + 0.5) / c.n};
      });
  wrong("these are random samples, without cells: i has no effect (with int, column / n is 0)",
        [](const Cell& c) {
          return Place2{c.a, c.b};
        });
  const char* first = "all samples are in the first cell: column / n and row / n as int are 0";
  wrong(first, [](const Cell& c) { return Place2{c.a / c.n, c.b / c.n}; });
  wrong("column / n and row / n as int are 0: add a and b first, then divide", [](const Cell&) {
    return Place2{0, 0};
  });
  wrong("columns and rows are exchanged: sample 1 is the right neighbor of sample 0",
        [](const Cell& c) {
          return Place2{(c.row + c.a) / c.n, (c.column + c.b) / c.n};
        });
  wrong("a and b are exchanged: a is across, b is up", [](const Cell& c) {
    return Place2{(c.column + c.b) / c.n, (c.row + c.a) / c.n};
  });
  wrong("a moves the sample across and up: b says how far up", [](const Cell& c) {
    return Place2{(c.column + c.a) / c.n, (c.row + c.a) / c.n};
  });
  wrong("u and v are exchanged: column and a make u, row and b make v", [](const Cell& c) {
    return Place2{(c.row + c.b) / c.n, (c.column + c.a) / c.n};
  });
  wrong("you divide by n x n: all samples are in one corner of the pixel", [](const Cell& c) {
    return Place2{(c.column + c.a) / (c.n * c.n), (c.row + c.b) / (c.n * c.n)};
  });
  wrong("n cells are as wide as the pixel: divide by n, not by n - 1", [](const Cell& c) {
    return Place2{(c.column + c.a) / (c.n - 1), (c.row + c.b) / (c.n - 1)};
  });
  wrong("n cells are as wide as the pixel: divide by n, not by n + 1", [](const Cell& c) {
    return Place2{(c.column + c.a) / (c.n + 1), (c.row + c.b) / (c.n + 1)};
  });
  wrong("these are cells, and the pixel goes from 0 to 1: divide by n", [](const Cell& c) {
    return Place2{c.column + c.a, c.row + c.b};
  });
  wrong("the division comes before the sum: write (column + a) / n", [](const Cell& c) {
    return Place2{c.column + c.a / c.n, c.row + c.b / c.n};
  });
  wrong("a and b are factors here: add them to column and row", [](const Cell& c) {
    return Place2{c.column * c.a / c.n, c.row * c.b / c.n};
  });
  wrong("a and b count from the corner of the cell: do not subtract or add 1/2", [](const Cell& c) {
    return Place2{(c.column + c.a - 0.5) / c.n, (c.row + c.b - 0.5) / c.n};
  });
  wrong("a and b count from the corner of the cell: do not subtract or add 1/2", [](const Cell& c) {
    return Place2{(c.column + c.a + 0.5) / c.n, (c.row + c.b + 0.5) / c.n};
  });
  wrong("a and b are not divided by n: the samples leave their cells", [](const Cell& c) {
    return Place2{c.column / c.n + c.a, c.row / c.n + c.b};
  });
  wrong("v is random: it is (row + b) / n", [](const Cell& c) {
    return Place2{(c.column + c.a) / c.n, c.b};
  });
  wrong("u is random: it is (column + a) / n", [](const Cell& c) {
    return Place2{c.a, (c.row + c.b) / c.n};
  });
  add_wrong_cells(mistakes);
  return mistakes;
}

Exercise one_sample_in_each_cell() {
  Law<PlaceOfSample> law{
      .right =
          [](int i, int n, double a, double b) {
            const int row = i / n;
            return Place2{(i % n + a) / n, (row + b) / n};
          },
      .places = {{"of 1 cell, the sample is at (a, b)", {0, 1, 0.25, 0.75}},
                 {"sample 0 of 4 x 4 is in the corner at (0, 0)", {0, 4, 0.5, 0.5}},
                 {"sample 3 is at the end of the first row", {3, 4, 0.5, 0.5}},
                 {"sample 4 begins the second row", {4, 4, 0.5, 0.5}},
                 {"sample 7 of 4 x 4, with a = 0.2 and b = 0.7", {7, 4, 0.2, 0.7}},
                 {"sample 8 of 3 x 3, with a = 0.9 and b = 0.1", {8, 3, 0.9, 0.1}}},
      .mistakes = wrong_places(),
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
