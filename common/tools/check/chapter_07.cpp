// The exercises of chapter 07. The lesson is the chapter's own. What it gets and calls leads to the
// student's function: the numbers of a sample, light_along, and the mean of the samples.
#include <numeric>

#include "engine/draw/develop.hpp"
#include "engine/run/layout_options.hpp"
#include "engine/run/sampling_options.hpp"
#include "exercises.hpp"
#include "math/srgb.hpp"
#include "sampling/samplers.hpp"
#include "scene/path.hpp"

namespace texmap::chapter_07 {

static std::function<int(const std::vector<int>&)> mean_byte;
static std::function<Vec3d(double, double, double)> through_window;
static std::function<Uv<double>(int, int, double, double)> place_of_sample;

/// The light along a ray, from a window above: one direction to it, chosen by the student.
inline constexpr struct {
  Rgb operator()(const auto& objects, const Ray<double>& ray, const auto& sky, int bounces,
                 auto& random) const {
    if (!through_window) return texmap::light_along(objects, ray, sky, bounces, random);
    const Nearest<double> nearest = find_nearest(objects, ray);
    if (nearest.index < 0) return sky(ray);
    const auto& object = objects[std::size_t(nearest.index)];
    const Hit<double> hit = hit_at(object.shape, ray, nearest.distance);
    const auto [a, b] = random.next_2d();
    const Vec3d way = through_window(a, b, 0.8);
    const Ray<double> up{hit.outside, {way.x, way.z, -way.y}};
    const bool open = find_nearest(objects, up).index < 0;
    return object.paint(hit) * (open ? max(dot(hit.normal, up.direction), 0.) : 0);
  }
} light_along;

}  // namespace texmap::chapter_07

#include "07_earth_by_sampling/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_07;

using Bytes = std::vector<int>;

constexpr int cells = 4;  // columns and rows of a pixel's samples

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
    const Place2 place = place_of_sample(sample, cells, random.u, random.v);
    return {place.u, place.v};
  }
};

/// A pixel from the light of its samples.
Rgb8 shown(const std::vector<Rgb>& samples) {
  const auto channel = [&](double Rgb::*part) {
    const auto byte = [](double light) { return cut_off(byte_of_light(light, Transfer::srgb)); };
    double sum = 0;
    Bytes bytes;
    for (const Rgb& light : samples) {
      sum += light.*part;
      bytes.push_back(byte(light.*part));
    }
    const double mean = sum / static_cast<double>(samples.size());
    return static_cast<std::uint8_t>(mean_byte ? clamp(mean_byte(bytes), 0, 255) : byte(mean));
  };
  return {channel(&Rgb::r), channel(&Rgb::g), channel(&Rgb::b)};
}

/// A lesson's picture in 100 x 75 pixels, each drawn as 4 x 4, so that single samples show.
Image magnified(const Lesson& lesson) {
  const struct {  // what the lesson calls a scene
    View<> view;
    const std::vector<chapter_07::Object>& objects;
    const GradientSky& sky;
  } scene{view_of(lesson.stage.camera, 100, 75), lesson.objects, lesson.stage.sky};
  const Sampler sampler(SamplerKind::random, cells * cells);
  Image image(400, 300);
  for (std::uint32_t i = 0; i < 100 * 75; ++i) {
    const std::uint32_t column = i % 100, row = i / 100;
    std::vector<Rgb> samples;
    for (int sample = 0; sample < cells * cells; ++sample) {
      Numbers random{sampler, hash_pixels<double>(column, row), sample};
      samples.push_back(lesson(scene, PixelPlace<double>{double(column), double(row)}, random));
    }
    const Rgb8 color = shown(samples);
    for (std::uint32_t k = 0; k < 16; ++k)
      image.at(int(4 * column + k % 4), int(4 * row + k / 4)) = color;
  }
  return image;
}

/// The globe alone, as in the book.
Lesson lone_globe(std::vector<std::string> words = {}) {
  words.insert(words.end(), {"--scene", "book"});
  return prepared<Lesson>(words);
}

/// A white globe, for which only the sky counts.
Lesson white_globe(const std::vector<std::string>& words = {}) {
  auto lesson = lone_globe(words);
  lesson.objects.front().paint.texture.image = Image(1, 1, {255, 255, 255});
  return lesson;
}

double sum_of(const Bytes& bytes, const auto& light_of) {
  return std::transform_reduce(bytes.begin(), bytes.end(), 0., std::plus<>(), light_of);
}
double decoded(double byte) { return srgb_decode(byte / 255); }

Slips<int> wrong_means(const Bytes& bytes) {
  const auto n = static_cast<double>(bytes.size());
  const auto sum = [&](auto light_of) { return sum_of(bytes, light_of); };
  const auto byte_of = [](double light) { return 255 * srgb_encode(light); };
  const double light = sum(decoded), mean = light / n;
  const double bytes_sum = sum([](int byte) { return byte; }), share = bytes_sum / 255 / n;
  const double as_255 = sum([](int byte) { return srgb_decode(double(byte)); }) / n;
  const double encoded = sum([](int byte) { return srgb_encode(byte / 255.); }) / n;
  const auto without = [&](int byte) { return round(byte_of((light - decoded(byte)) / n)); };
  const auto power = [&](double p) {
    return 255 * pow(sum([=](int byte) { return pow(byte / 255., p); }) / n, 1 / p);
  };
  Bytes sorted = bytes;
  std::sort(sorted.begin(), sorted.end());
  const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
  const double below = *(sorted.size() % 2 == 1 ? middle : middle - 1);
  const auto* not_256 = "white is byte 255, and there it is 1: divide and multiply by 255, not 256";
  const Slips<double> wrong = {
      {"the byte is cut off, not rounded: take std::lround",
       {floor(byte_of(mean)), floor(255.999 * srgb_encode(mean)), ceil(byte_of(mean))}},
      {"every byte but 255 counts as 0: write byte / 255.0, and add in a double",
       byte_of(sum([](int byte) { return byte == 255 ? 1 : 0; }) / n)},
      {"decode each byte, and encode the mean",
       {{"this is the mean of the bytes, not of the light", bytes_sum / n},
        {"the mean is light and no byte yet", 255 * mean},
        {"decoding and encoding are exchanged", 255 * srgb_decode(encoded)},
        {"the bytes are not decoded, but their mean is encoded, too bright", byte_of(share)},
        {"the mean of the bytes is decoded", 255 * srgb_decode(share)},
        {"you decode each byte and the mean again", 255 * srgb_decode(mean)},
        {"the sum is encoded before it is divided", byte_of(light) / n},
        {"a byte is encoded already", 255 * encoded}}},
      {"this is 0 to 1: encode the mean, and multiply it by 255", {srgb_encode(mean), mean}},
      {"divide the sum by bytes.size(), then encode it", {byte_of(light), 255 * light, bytes_sum}},
      {"srgb_decode takes 0 to 1: give it byte / 255.0", {byte_of(as_255), srgb_encode(as_255)}},
      {not_256, byte_of(sum([](int byte) { return srgb_decode(byte / 256.); }) / n)},
      {"the bytes are not encoded by this power alone: take srgb_decode and srgb_encode",
       {power(2), power(2.2), 255 * pow(mean, 1 / 2.2),
        byte_of(sum([](int byte) { return pow(byte / 255., 2.2); }) / n)}},
      {"the mean is the sum of the light, divided by how many there are",
       {{"this is the median, the byte in the middle",
         {1. * *middle, below, (below + *middle) / 2,
          byte_of((decoded(below) + decoded(*middle)) / 2)}},
        {"this is one of the bytes",
         {1. * bytes.front(), 1. * bytes.back(), 1. * sorted.front(), 1. * sorted.back()}},
        {"divide by no other number", {byte_of(light / max(n - 1, 1.)), byte_of(light / (n + 1))}},
        {"a byte is missing in the sum", {without(bytes.front()), without(bytes.back())}}}},
  };
  return {
      changed(wrong, rounded),
      changed(wrong, cut_off),
      {not_256, rounded(256 * srgb_encode(mean))},
  };
}

/// The direction at such a height.
Vec3d direction_at(double z, double angle) {
  const double radius = sqrt(1 - z * z);
  return {radius * cos(angle), radius * sin(angle), z};
}
Vec3d right_direction(double a, double b, double edge) {
  return direction_at(1 - a * (1 - edge), 2 * pi * b);
}

Slips<Vec3d> wrong_directions(double a, double b, double edge) {
  const double turn = 2 * pi * b, height = 1 - edge, radius = sqrt(1 - edge * edge);
  const auto [x, y, z] = right_direction(a, b, edge);
  const Slips<double> heights = {
      {"the root spreads points evenly over a disk, as on the page: here spread the height evenly",
       {sqrt(1 - a), sqrt(1 - a * radius * radius), 1 - sqrt(a) * height}},
      {"too many are near the middle: spread the height evenly, not the angle or the radius",
       {cos(a * acos(edge)), sqrt(1 - a * a * radius * radius), 1 - a * a * height}},
      {"the height is 1 - a * (1 - edge)",
       {{"a = 0 is straight up", edge + a * height},
        {"it ends at the height edge", {1 - a, a, 1 - 2 * a, 1 - a * edge, 1 - a - edge, a * edge}},
        {"a = 0 has the height 1, and a = 1 the height edge", {(1 - a) * edge, 1 - (1 - a) * edge}},
        {"all directions go to the edge of the window", edge}}},
  };
  const Slips<double> radii = {
      {"the length is not 1: at the height z the radius is the root of 1 - z * z",
       {1 - z * z, 1 - z, sqrt(1 - z), 1, a, sqrt(a), a * height, a * radius, sqrt(a) * radius,
        radius}},
  };
  const auto with = [=, z = z](double r) { return Vec3d{r * cos(turn), r * sin(turn), z}; };
  const Slips<double> angles = {
      {"the angle is 2 pi b",
       {{"your directions cover half of the window", pi * b},
        {"b is a share of a turn, and std::cos takes radians",
         {b, 360 * b, 360 / radian * b, pi * pi / 90 * b}}}},
      {"the angle runs the other way: count it from x toward y", -turn},
  };
  return {
      changed(heights, [=](double other) { return direction_at(other, turn); }),
      changed(radii, with),
      {"you make the length 1 at the end, and move the height: the radius is the root of 1 - z * z",
       {normalize(with(1)), normalize(with(a)), normalize(with(sqrt(a))), normalize(with(radius))}},
      changed(angles, [=, z = z](double angle) { return direction_at(z, angle); }),
      {"your directions lead into the ground: the height is above 0", {{x, y, -z}, {-x, -y, -z}}},
      {"a makes the height, b the angle",
       {{"a and b are exchanged", right_direction(b, a, edge)},
        {"one makes both", {right_direction(a, a, edge), right_direction(b, b, edge)}}}},
  };
}

constexpr Place<double, double, double> through_window_places[] = {
    {"a = 0 is straight up", {0.0, 0.5, 0.5}},
    {"edge 0.5 and a = 1/2: the height is 0.75; b = 0 is in the direction +x", {0.5, 0.0, 0.5}},
    {"b = 1/4 is a quarter turn from there: +y", {0.5, 0.25, 0.5}},
    {"b = 1/2 is half a turn: -x", {0.5, 0.5, 0.5}},
    {"edge 0 is the whole hemisphere: a = 0.4 has the height 0.6", {0.4, 0.75, 0}},
    {"edge 0.9 is a small window: a = 0.8 has the height 0.92", {0.8, 0.125, 0.9}},
};

Place2 right_place(int i, int n, double a, double b) {
  const int row = i / n;
  return {(i % n + a) / n, (row + b) / n};
}

Slips<Place2> wrong_places(int i, int n, double a, double b) {
  const double c = i % n, r = floor(double(i) / n);  // column and row
  const auto [u, v] = right_place(i, n, a, b);
  const auto at = [=](double column, double row) {
    return Place2{(column + a) / n, (row + b) / n};
  };
  return {
      {"all samples of a cell are at its corner: add a and b", {c / n, r / n}},
      {"all samples are in the middle of their cells, which makes stripes: add a and b",
       {(c + 0.5) / n, (r + 0.5) / n}},
      {"these are random samples, without cells: i has no effect (as int, c / n is 0)", {a, b}},
      {"column / n and row / n as int are 0: add, then divide", {{a / n, b / n}, {0, 0}}},
      {"columns and rows are exchanged: sample 1 is the right neighbor of sample 0", at(r, c)},
      {"a is across, b is up",
       {{"a and b are exchanged", {(c + b) / n, (r + a) / n}},
        {"a moves the sample across and up", {u, (r + a) / n}}}},
      {"u is (column + a) / n, and v is (row + b) / n",
       {{"you divide by n x n", {u / n, v / n}},
        {"n cells are as wide as the pixel, not n - 1 or n + 1",
         {{(c + a) / (n - 1), (r + b) / (n - 1)}, {(c + a) / (n + 1), (r + b) / (n + 1)}}},
        {"the pixel goes from 0 to 1, and yours is in cells", {c + a, r + b}},
        {"the division comes before the sum", {c + a / n, r + b / n}},
        {"a and b are factors here", {c * a / n, r * b / n}},
        {"a and b are not divided by n, and the samples leave their cells", {c / n + a, r / n + b}},
        {"a and b count from the cell's corner", {at(c - 0.5, r - 0.5), at(c + 0.5, r + 0.5)}},
        {"one of them is random", {{u, b}, {a, v}}}}},
      {"the rows are upside down: v begins at 0 with row 0", {at(c, n - 1 - r), {u, 1 - v}}},
      {"the column is i % n, and the row is i / n as int",
       {{"samples are counted from 0, without 1", {right_place(i + 1, n, a, b), at(c - 1, r)}},
        {"you take one of them for both", {at(c, c), at(r, r)}},
        {"the row is no whole number", at(c, double(i) / n)},
        {"i counts samples, and is no column or row",
         {at(i, r),
          at(c, i),
          {(i + a) / n / n, (i + b) / n / n},
          {(i + a) / n / n, b},
          {a, (i + b) / n / n}}}}},
  };
}

constexpr Place<int, int, double, double> place_of_sample_places[] = {
    {"of 1 cell, the sample is at (a, b)", {0, 1, 0.25, 0.75}},
    {"sample 0 of 4 x 4 is in the corner at (0, 0)", {0, 4, 0.5, 0.5}},
    {"sample 3 is at the end of the first row", {3, 4, 0.5, 0.5}},
    {"sample 4 begins the second row", {4, 4, 0.5, 0.5}},
    {"sample 7 of 4 x 4, with a = 0.2 and b = 0.7", {7, 4, 0.2, 0.7}},
    {"sample 8 of 3 x 3, with a = 0.9 and b = 0.1", {8, 3, 0.9, 0.1}},
};

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const Place<Bytes> mean_byte_places[] = {
      {"the mean of one byte is this byte", {Bytes{76}}},
      {"the mean of equal bytes is this byte", {{200, 200, 200}}},
      {"half black and half white sends out half of the light: byte 188", {{0, 255}}},
      {"three quarters black", {{0, 255, 0, 0}}},
      {"two dark bytes, 20 and 40: 31.55, so byte 32", {{20, 40}}},
      {"a dark and a bright byte", {{40, 180}}},
      {"many bytes", {{10, 20, 40, 80, 160, 250, 130, 70}}},
      {"white stays white", {{255, 255}}},
  };
  static const ExercisesOfChapter chapter{
      "07",
      {exercise(mean_byte,
                [] {
                  return magnified(lone_globe({"--defocus", "4", "--focus", "6"}));
                },
                {[](const Bytes& bytes) {
                   return rounded(255 * srgb_encode(sum_of(bytes, decoded) / double(bytes.size())));
                 },
                 wrong_means, mean_byte_places}),
       exercise(through_window,
                [] {
                  auto lesson = prepared<Lesson>();
                  lesson.stage.sky = {.below = {0, 0, 0}, .above = {0, 0, 0}};
                  return magnified(lesson);
                },
                {right_direction, wrong_directions, through_window_places}),
       exercise(place_of_sample, [] { return magnified(lone_globe()); },
                {right_place, wrong_places, place_of_sample_places})},
      {{"Which byte does a pixel get that is a quarter white, the rest black?",
        [] { return double(byte_of_light(0.25, Transfer::srgb)); },
        {"", 0},
        "A quarter of the pixel sends out light. Which encoded number has a quarter of the light?",
        {{64, "this is the mean of the bytes: average the light, and encode it"},
         {225, "this is three quarters of the light: a quarter of the pixel is white"}}},
       {"Draw a white globe (albedo 1) alone, with --scene book. How many pixels differ from the "
        "sky?",
        [] {
          const auto pixels = magnified(white_globe()).pixels;
          return double(
              std::count_if(pixels.begin(), pixels.end(), [&](Rgb8 p) { return p != pixels[0]; }));
        },
        {"pixels", 0},
        "How much light reaches a point of the globe, and how much of it does albedo 1 send back?",
        {}}},
  };
  return chapter;
}

}  // namespace texmap::check
