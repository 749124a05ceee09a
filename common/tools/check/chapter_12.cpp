// The exercises of chapter 12. The lesson's light_under_sky is here light straight from the sky, by
// several directions with the student's weights.
#include <numeric>

#include "engine/draw/develop.hpp"
#include "engine/draw/gather.hpp"
#include "exercises.hpp"
#include "sampling/directions.hpp"
#include "scene/sky_path.hpp"
#include "texture/sky_light.hpp"
#include "texture/sky_texels.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::chapter_12 {

static std::function<Vec3d(Uv<double>)> mirrored_sky;
static std::function<double(const std::vector<double>&)> light_of_ground;
static std::function<double(double, double, int, int)> weight_of;

inline constexpr struct {
  Rgb operator()(const auto& objects, const Ray<double>& ray, const auto& sky,
                 const MatteLight& /*matte*/, int /*bounces*/, auto& random) const {
    return color_along(objects, ray, sky, [&](const auto& object, const Hit<double>& hit) {
      if (object.paint.mirrors)
        return sky(Ray<double>{hit.outside, mirror(-normalize(ray.direction), hit.normal)});
      constexpr int by_cosine = 2, by_sky = 5;
      Rgb light{};
      for (int i = 0; i < by_cosine + by_sky; ++i) {
        const Point2<double> drawn = random.next_2d();
        const Vec3d to_sky =
            i < by_cosine ? cosine_direction(hit.normal, drawn) : sky.draw(true, drawn).direction;
        const double cosine = dot(hit.normal, to_sky);
        const double weight =
            weight_of(cosine, sky.density(true, sky.toward(to_sky)), by_cosine, by_sky);
        const Ray<double> way{hit.outside, to_sky};
        if (find_nearest(objects, way).index < 0) light = light + sky(way) * weight;
      }
      return object.paint(hit) * light;
    });
  }
} light_under_sky;

}  // namespace texmap::chapter_12

#include "12_environment_map/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_12;

/// The scene by directions to the sky, without light from object to object.
Image scene() {
  const auto lesson = prepared<Lesson>();
  const View<> view = view_of(lesson.stage.camera, 400, 300);
  return develop(
      gather<double>(lesson, lesson.objects, view, {Sampler(SamplerKind::sobol, 1)}, {}, {}),
      Transfer::srgb);
}

/// The photograph of a ball that mirrors the chapter's sky.
Image photograph() {
  const auto lesson = prepared<Lesson>();
  Image image(400, 300);
  for (int row = 0; row < 300; ++row) {
    std::vector<Rgb> light(400, gray(0.02));
    for (int column = 50; column < 350; ++column) {
      const Place2 place{(column - 50 + 0.5) / 300, 1 - (row + 0.5) / 300};
      if (std::hypot(place.u - 0.5, place.v - 0.5) < 0.499)
        light[std::size_t(column)] = lesson.stage.sky(Ray<double>{{}, mirrored_sky(place)});
    }
    develop_row(light.data(), Transfer::srgb, image, row);
  }
  return image;
}

Slips<Vec3d> wrong_skies(Place2 uv) {
  const double x = 2 * uv.u - 1, y = 2 * uv.v - 1, square = x * x + y * y, z = sqrt(1 - square);
  const auto by = [](const Vec3d& n) { return mirror(Vec3d{0, 0, 1}, n); };
  const Vec3d right = by({x, y, z});
  return {
      {"this is the ball's normal: as if the sky were painted on the ball", {x, y, z}},
      {"e leads from the ball back to the camera: it is (0, 0, 1)", -right},
      {"r is 2 (n . e) n - e",
       {{"the 2 is missing", Vec3d{x * z, y * z, z * z - 1}},
        {"e is added", Vec3d{2 * x * z, 2 * y * z, 2 * z * z + 1}},
        {"e is missing", Vec3d{2 * x * z, 2 * y * z, 2 * z * z}}}},
      {"x and y run from -1 to 1 in the picture: take 2 u - 1 and 2 v - 1",
       {by({uv.u, uv.v, sqrt(1 - uv.u * uv.u - uv.v * uv.v)}),
        by({uv.u - 0.5, uv.v - 0.5, sqrt(max(1 - square / 4, 0.0))})}},
      {"n has the length 1: z is sqrt(1 - x * x - y * y)",
       {by({x, y, 1 - square}), by({x, y, 1 - sqrt(square)}), by({x, y, 1}), by({x, y, 0}),
        by(normalize(Vec3d{x, y, 1}))}},
      {"this is the map of a sky, as on the page: a photograph shows a disk", direction_rtiow(uv)},
      {"the visible half of the ball faces the camera: z is above 0", by({x, y, -z})},
      {"v grows upward, with y", {by({x, -y, z})}},
      {"u grows to the right, with x", {by({-x, y, z})}},
  };
}

Vec3d right_sky(Place2 uv) {
  const double x = 2 * uv.u - 1, y = 2 * uv.v - 1, z = sqrt(1 - x * x - y * y);
  return {2 * x * z, 2 * y * z, 2 * z * z - 1};
}
constexpr Place<Place2> mirrored_sky_places[] = {
    {"the middle shows the camera itself, +z", {{0.5, 0.5}}},
    {"where the ball leans by 45 degrees to the right, +x is seen", {{0.5 + half_root / 2, 0.5}}},
    {"where it leans by 45 degrees downward, -y is seen", {{0.5, 0.5 - half_root / 2}}},
    {"at u = 0.8, v = 0.5 the normal is (0.6, 0, 0.8): (0.96, 0, 0.28)", {{0.8, 0.5}}},
    {"close to the outline one sees what is behind the ball", {{0.02, 0.5}}},
    {"at (1/6, 5/6), where the normal is (-2, 2, 1) / 3", {{1 / 6., 5 / 6.}}},
};

using Rows = std::vector<double>;

/// The sum of the rows, each times what it counts from its angle a to b, straight up 0.
double sum_of(const Rows& rows, const std::function<double(double a, double b)>& counts,
              double last = pi / 2, double turn = pi) {
  double sum = 0;
  const double step = turn / static_cast<double>(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    sum += rows[i] * counts(min(double(i) * step, last), min(double(i + 1) * step, last));
  return sum;
}
double ring(double a, double b) { return sin(b) * sin(b) - sin(a) * sin(a); }
double right_ground(const Rows& rows) {  // the ring, by another formula
  return sum_of(rows, [](double a, double b) { return sin(b - a) * sin(b + a); });
}

Slips<double> wrong_grounds(const Rows& rows) {
  const double right = right_ground(rows), size = double(rows.size());
  const auto half = static_cast<std::ptrdiff_t>(rows.size() / 2);
  const Rows upper(rows.begin(), rows.begin() + half);
  return {
      {"below the horizon nothing counts: there the cosine is below 0", sum_of(rows, ring, pi)},
      {"Lambert's cosine is missing: light from the side counts less",
       {sum_of(rows, [](double a, double b) { return cos(a) - cos(b); }),
        sum_of(rows, [](double a, double b) { return cos(a) - cos(b); }) / 2}},
      {"the solid angle is missing: a row near the zenith is small",
       {sum_of(rows, [](double a, double b) { return sin(b) - sin(a); }),
        sum_of(rows, [](double a, double b) { return cos((a + b) / 2) * (b - a); })}},
      {"each row counts its ring, not what is in its middle",
       {sum_of(rows, [](double a, double b) { return sin(a + b) * (b - a); }),
        sum_of(
            rows, [](double a, double b) { return max(sin(a + b), 0.) * (b - a); }, pi),
        sum_of(rows, [](double a, double b) { return cos((a + b) / 2) * (cos(a) - cos(b)) * 2; })}},
      {"both factors are missing: all rows above the horizon count the same",
       {half > 0 ? std::accumulate(upper.begin(), upper.end(), 0.) / double(half) : 0,
        sum_of(rows, [](double a, double b) { return (b - a) / (pi / 2); }),
        sum_of(
            rows, [](double a, double b) { return (b - a) / pi; }, pi)}},
      {"the disk's area is pi: divide by it", {right * pi, right * 2 * pi}},
      {"under a sky of light 1 it is 1: yours is half of it, or twice", {right / 2, right * 2}},
      {"the row that the horizon divides counts up to the horizon: there b is pi / 2",
       sum_of(upper, ring, pi, pi / size * double(half))},
      {"a sine alone is a radius: areas go with its square", {sqrt(max(right, 0.)), right * right}},
  };
}

/// What ground looks like under skies with a lamp of different heights: the sky above the ground.
Image skies() {
  const auto rows_of = [](int panel) {
    Rows rows(static_cast<std::size_t>(9 + panel), 0.2);
    rows[static_cast<std::size_t>(panel) * 5 / 11] = 1;
    return rows;
  };
  std::vector<double> grounds;
  grounds.reserve(12);
  for (int panel = 0; panel < 12; ++panel) grounds.push_back(light_of_ground(rows_of(panel)));
  return panels([&](int panel, double, double y) {
    const Rows rows = rows_of(panel);
    const auto row = static_cast<std::size_t>((1 - y) * double(rows.size()));
    return y < 0.5 ? grounds[static_cast<std::size_t>(panel)] : rows[row];
  });
}

Slips<double> wrong_weights(double cosine, double q, int m, int k) {
  const double above = max(cosine, 0.), p = above / pi, all = m + k;
  const double both = m * p + k * q, right = p / both;
  return {
      {"this is the page's weight, for one direction by each way", p / (p + q)},
      {"in the mean the directions of both ways are m p + k q, and you divide by how many, too",
       {p / (p + q) / all, right / all}},
      {"the sum over all directions is the result: it is not divided by m + k again", right * all},
      {"below the surface there is no light: return 0", cosine / pi / (m * cosine / pi + k * q)},
      {"the first way's density is cosine / pi: compare the densities as they are",
       {above / (m * above + k * q), p / (m * above + k * q), above / (m * pi * above + k * q)}},
      {"1 / pi is missing: the light that leaves is albedo / pi", above / both},
      {"Lambert's cosine is missing", {1 / both, above > 0 ? 1 / both : 0, 1 / pi / both}},
      {"m belongs to the cosine, and k to the sky", p / (k * p + m * q)},
      {"divide by the densities of both ways, whichever drew the direction",
       {p / (k * q), above / (pi * q), above > 0 ? 1. / m : 0, p / q}},
  };
}

constexpr Place<double, double, int, int> weight_of_places[] = {
    {"one direction by each way, straight ahead, where both densities are 1 / pi: a half",
     {1, 1 / pi, 1, 1}},
    {"three by the cosine alone, 1 of the sky's that never comes there: a third", {0.5, 0, 3, 1}},
    {"below the surface: 0", {-0.6, 0.4, 2, 2}},
    {"two by the cosine and five by the sky, where it is bright", {0.6, 3, 2, 5}},
    {"the same where it is dark", {0.6, 0.01, 2, 5}},
    {"four by the cosine and one by the sky", {0.3, 0.5, 4, 1}},
};

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

ExercisesOfChapter all_exercises_of_chapter() {
  static const Place<Rows> light_of_ground_places[] = {
      {"a sky of light 1: the ground has 1", {Rows{1, 1, 1, 1}}},
      {"two rows: all that counts is the upper one", {{0.5, 7}}},
      {"of 4 rows the first ends at 45 degrees: half of the disk", {{1, 0, 0, 0}}},
      {"the second of 4 rows has the other half", {{0, 0.6, 0, 0}}},
      {"of 6 rows the first is a quarter of the disk", {{0.4, 0, 0, 0, 0, 0}}},
      {"one row: its upper half", {{0.7}}},
      {"3 rows: the horizon divides the middle one", {{0.1, 0.9, 0.3}}},
      {"5 rows", {{0.9, 0.2, 0.6, 0.8, 0.4}}},
      {"many rows", {{0.1, 0.3, 0.2, 0.9, 0.8, 0.5, 0.3, 0.2, 0.7, 0.1}}},
  };
  return {
      "12",
      {exercise(mirrored_sky, photograph, {right_sky, wrong_skies, mirrored_sky_places}),
       exercise(light_of_ground, skies, {right_ground, wrong_grounds, light_of_ground_places}),
       exercise(weight_of, scene,
                {[](double cosine, double q, int m, int k) {
                   const double by_cosine = max(cosine, 0.) / pi;
                   return by_cosine > 0 ? by_cosine / (m * by_cosine + k * q) : 0;
                 },
                 wrong_weights, weight_of_places})},
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
}

}  // namespace texmap::check
