// The exercises of chapter 07. The lesson is the chapter's own. What it gets and calls leads to the
// student's function: a sample's place on the lens, light_along, and the mean of the samples.
#include <numeric>
#include <optional>

#include "engine/draw/develop.hpp"
#include "exercises.hpp"
#include "math/srgb.hpp"
#include "sampling/samplers.hpp"
#include "scene/path.hpp"

namespace texmap::chapter_07 {

static std::function<int(const std::vector<int>&)> mean_byte;
static std::function<Vec3d(double, double, double)> through_window;
static std::function<Uv<double>(int, int, double, double, double)> place_on_lens;

/// The light along a ray, from a window above: one direction to it, chosen by the student.
inline constexpr struct {
  Rgb operator()(const auto& objects, const Ray<double>& ray, const auto& sky, int bounces,
                 auto& random) const {
    if (!through_window) return texmap::light_along(objects, ray, sky, bounces, random);
    return color_along(objects, ray, sky, [&](const auto& object, const Hit<double>& hit) {
      const Point2<double> at = random.next_2d();
      const Vec3d way = through_window(at.u, at.v, 0.8);
      const Ray<double> up{hit.outside, {way.x, way.z, -way.y}};
      const bool open = find_nearest(objects, up).index < 0;
      return object.paint(hit) * (open ? max(dot(hit.normal, up.direction), 0.) : 0);
    });
  }
} light_along;

}  // namespace texmap::chapter_07

#include "07_earth_by_sampling/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_07;

using Bytes = std::vector<int>;

constexpr int samples_of_pixel = 16;
constexpr double radius_of_hole = 0.6;  // in the lens

/// Two numbers of a sample, and its place on the lens if the student says it.
struct Sample2 : Point2<double> {
  std::optional<Place2> on_lens;
};
OnDisk<double> uniform_disk(const Sample2& sample) {
  if (!sample.on_lens) return texmap::uniform_disk<double>(sample);
  return {.x = sample.on_lens->u, .y = sample.on_lens->v, .radius = 1, .height = 0};
}

/// The numbers of one sample.
struct Numbers {
  const Sampler& sampler;
  std::uint32_t pixel;
  int sample;
  std::uint32_t dimension = 0;

  Sample2 next_2d() {
    const auto random =
        sampler.pair<double>(pixel, static_cast<std::uint32_t>(sample), dimension++);
    if (dimension != 2 || !place_on_lens) return {random, {}};
    return {random, place_on_lens(sample, samples_of_pixel, random.u, random.v, radius_of_hole)};
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
  const Sampler sampler(SamplerKind::random, samples_of_pixel);
  const Image small = image_of(100, 75, [&](int column, int row) {
    const auto pixel = hash_pixels<double>(std::uint32_t(column), std::uint32_t(row));
    std::vector<Rgb> samples;
    for (int sample = 0; sample < samples_of_pixel; ++sample) {
      Numbers random{sampler, pixel, sample};
      samples.push_back(lesson(scene, PixelPlace<double>{double(column), double(row)}, random));
    }
    return shown(samples);
  });
  return image_of(400, 300, [&](int column, int row) { return small.at(column / 4, row / 4); });
}

/// The globe alone, as in the book.
Lesson lone_globe(std::vector<std::string> words = {}) {
  words.insert(words.end(), {"--scene", "book"});
  return prepared<Lesson>(words);
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

Place2 right_place(int i, int n, double a, double b, double inner) {
  const double radius = std::lerp(inner * inner, 1, (i + a) / n);
  return {sqrt(radius) * cos(2 * pi * b), sqrt(radius) * sin(2 * pi * b)};
}

Slips<Place2> wrong_places(int i, int n, double a, double b, double inner) {
  const double turn = 2 * pi * b, hole = inner * inner, share = (i + a) / n;
  const auto radius_at = [=](double part) { return sqrt(hole + part * (1 - hole)); };
  const auto at = [](double radius, double angle) {
    return Place2{radius * cos(angle), radius * sin(angle)};
  };
  const Slips<double> radii = {
      {"equal steps of the radius: the inner rings get too many samples. Take steps of the area",
       inner + share * (1 - inner)},
      {"the root of the share is right for a disk: here the hole's area, inner * inner, comes "
       "first",
       {sqrt(share), inner + sqrt(share) * (1 - inner), sqrt(hole + share), inner + sqrt(share)}},
      {"the ring's area is 1 - inner * inner, in units of pi",
       {sqrt(hole + share * (1 - inner) * (1 - inner)), sqrt(hole + share * (1 - inner)),
        sqrt(inner + share * (1 - inner))}},
      {"an area is the square of the radius: the root is missing", hole + share * (1 - hole)},
      {"all samples of a ring are on its inner edge: add a to i", radius_at(i * 1. / n)},
      {"these are random samples, without rings: i has no effect (as int, i / n is 0)",
       {radius_at(a), radius_at(a / n), inner + a * (1 - inner), sqrt(a)}},
      {"the share is (i + a) / n",
       {radius_at(i + a), radius_at(i + a / n), radius_at(i * 1. / n + a), radius_at(i * a / n),
        radius_at((i + a) / (n - 1)), radius_at((i + a) / (n + 1)), radius_at((i + 1 + a) / n),
        radius_at((i - 1 + a) / n)}},
  };
  const Slips<double> angles = {
      {"b is a share of a turn, and std::cos takes radians: the angle is 2 pi b",
       {b, 360 * b, pi * b, pi / 2 * b}},
      {"the angle runs the other way: count it from x toward y", -turn},
  };
  return {
      {"a and b are exchanged: a says how far out, b on which side",
       right_place(i, n, b, a, inner)},
      changed(radii, [=](double radius) { return at(radius, turn); }),
      changed(angles, [=](double angle) { return at(radius_at(share), angle); }),
  };
}

constexpr Place<int, int, double, double, double> place_on_lens_places[] = {
    {"of 1 ring without a hole, a = 1/4 is half of the way out", {0, 1, 0.25, 0, 0}},
    {"sample 0 with a = 0 is at the edge of the hole", {0, 4, 0, 0, 0.5}},
    {"b = 1/4 is a quarter turn: up, toward +y", {0, 1, 0.5, 0.25, 0.28}},
    {"one ring from 0.6 to 1, a = 1/4: radius * radius = 0.36 + 0.64 / 4", {0, 1, 0.25, 0, 0.6}},
    {"sample 3 of 4 is in the last ring", {3, 4, 0.5, 0.125, 0.6}},
    {"sample 5 of 16, with a = 0.3 and b = 0.6", {5, 16, 0.3, 0.6, 0.8}},
};

}  // namespace

ExercisesOfChapter all_exercises_of_chapter() {
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
  return {
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
       exercise(place_on_lens,
                [] {
                  return magnified(lone_globe({"--defocus", "8", "--focus", "6"}));
                },
                {right_place, wrong_places, place_on_lens_places})},
      {{"Which byte does a pixel get that is a quarter white, the rest black?",
        [] { return double(byte_of_light(0.25, Transfer::srgb)); },
        {"", 0},
        "A quarter of the pixel sends out light. Which encoded number has a quarter of the light?",
        {{64, "this is the mean of the bytes: average the light, and encode it"},
         {136, "bytes are rounded to the nearest here, not cut off"},
         {225, "this is three quarters of the light: a quarter of the pixel is white"}}},
       {"Draw a white globe (albedo 1) alone, with --scene book. How many pixels differ from the "
        "sky?",
        [] {
          auto white = lone_globe();  // for which only the sky counts
          white.objects.front().paint.texture.image = Image(1, 1, {255, 255, 255});
          const auto pixels = magnified(white).pixels;
          return double(
              std::count_if(pixels.begin(), pixels.end(), [&](Rgb8 p) { return p != pixels[0]; }));
        },
        {"pixels", 0},
        "How much light reaches a point of the globe, and how much of it does albedo 1 send back?",
        {}}},
  };
}

}  // namespace texmap::check
