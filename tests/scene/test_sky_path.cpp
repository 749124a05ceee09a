// Tests of common/scene/sky_path.hpp: light from a sky that is a picture, found in five ways.
#include "scene/sky_path.hpp"

#include <doctest.h>

#include <numbers>

#include "sampling/sampled_numbers.hpp"
#include "scene/paint.hpp"
#include "scene/shapes.hpp"
#include "texture/sky_light.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::test {
namespace {

using Numbers = SampledNumbers<double>;
constexpr std::array sampled_ways = {SkyLighting::uniform, SkyLighting::cosine,
                                     SkyLighting::importance, SkyLighting::mis};

/// Mean and relative variance.
struct Spread {
  double mean, variance;
};
template <class Draw>
Spread spread(const Draw& draw) {
  constexpr int count = 16384;
  double sum = 0, squares = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    Numbers numbers{{SamplerKind::sobol, count}, i};
    const double value = draw(numbers);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / count;
  return {mean, squares / count / (mean * mean) - 1};
}

/// The light that a white surface with this normal sends out, by one sample: a lone white ball's.
double one_sample(SkyLighting way, const SkyLight& sky, const Vec3d& normal, Numbers& numbers) {
  const std::vector<Painted<Coat>> ball = {{.shape = {}, .paint = {{1, 1, 1}}}};
  return light_under_sky(ball, Ray<double>{normal * 3.0, -normal}, sky, {way}, 1, numbers).g;
}

/// The same by summing over 16 x 16 places in each texel.
double summed(const SkyLight& sky, const Vec3d& normal) {
  const int columns = 16 * sky.picture.map().width, rows = 16 * sky.picture.map().height;
  double sum = 0;
  for (int row = 0; row < rows; ++row) {
    const double v = (row + 0.5) / rows;
    for (int column = 0; column < columns; ++column) {
      const Vec3d d =
          sky.picture.from_map(direction_rtiow(Uv<double>{(column + 0.5) / columns, v}));
      sum += on_circle(v / 2).sine * std::max(dot(normal, d), 0.0) * sky(Ray<double>{{}, d}).g;
    }
  }
  return sum * 2 * std::numbers::pi / columns / rows;
}

/// A sky brighter above, with a sun.
LightImage with_sun(float sun) {
  LightImage image(32, 16);
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < 32; ++column)
      image.at(column, row) = gray(1 - static_cast<float>(row) / 20);
  }
  image.at(20, 4) = gray(sun);
  return image;
}

SkyLight constant_sky(float light) { return SkyLight(Environment(LightImage(4, 2, gray(light)))); }

const std::vector<Painted<Coat>> two_balls = {
    {.shape = {.center = {0, 0, 0}, .radius = 1}, .paint = {{1, 1, 1}}},
    {.shape = {.center = {1.8, 0, 0}, .radius = 0.8}, .paint = {{1, 1, 1}}}};

/// A path by `mis` as page 12 shows it, in plain C++.
struct PlainSkyPath {
  const std::vector<Painted<Coat>>& objects;
  const SkyLight& sky;
  Numbers& random;

  /// @param cosine  at the matte surface that the ray leaves; 0 if it leaves the eye or a mirror
  Rgb light(const Ray<double>& ray, int bounces, double cosine = 0) {
    const Nearest<double> nearest = find_nearest(objects, ray);
    if (nearest.distance == infinity<double>())
      return cosine == 0 ? sky(ray) : sky(ray) * weight(cosine, ray.direction);
    if (bounces == 0) return {0, 0, 0};
    const Painted<Coat>& object = objects[static_cast<std::size_t>(nearest.index)];
    const Hit<double> hit = hit_at(object.shape, ray, nearest.distance);
    const Point2<double> in_disk = random.next_2d();
    const Point2<double> in_sky = random.next_2d();

    if (object.paint.mirrors && cosine == 0) {
      const Vec3<double> mirrored = mirror(-ray.direction, hit.normal);
      return object.paint.color * light({hit.outside, mirrored}, bounces - 1);
    }
    const Vec3<double> scattered = cosine_direction(hit.normal, in_disk);
    Rgb sum = light({hit.outside, scattered}, bounces - 1, dot(hit.normal, scattered));

    const Ray<double> to_sky = {hit.outside, sky.draw(true, in_sky).direction};
    const double toward = dot(hit.normal, to_sky.direction);
    if (toward > 0 && !is_hidden(objects, to_sky, nearest.index))
      sum = sum + sky(to_sky) * weight(toward, to_sky.direction);
    return object.paint.color * sum;
  }

  double weight(double cosine, const Vec3<double>& direction) const {
    return cosine / (cosine + std::numbers::pi * sky.density(true, sky.toward(direction)));
  }
};

}  // namespace

TEST_CASE(
    "white balls and mirrors under a sky of ones cannot be told from it, however long paths are") {
  const SkyLight sky = constant_sky(1);
  for (const bool mirrors : {false, true}) {
    for (const bool caustics : {false, true}) {
      std::vector<Painted<Coat>> balls = two_balls;
      balls[1].paint.mirrors = mirrors;
      for (std::uint32_t i = 0; i < 512; ++i) {
        Numbers numbers{{SamplerKind::random, 512}, i};
        const Ray<double> ray = {{0.2, 0.1, 5}, {0.003 * (i % 256), 0, -5}};
        const Color<double> light =
            light_under_sky(balls, ray, sky, {SkyLighting::cosine, caustics}, 1000, numbers);
        REQUIRE(light.g == 1);
      }
    }
  }
}

TEST_CASE("all ways to draw directions find the same light, under every sky and normal") {
  for (const float sun : {0.5F, 30.0F, 1000.0F}) {
    for (const TexelFilter filter : {TexelFilter::nearest, TexelFilter::bilinear}) {
      const SkyLight sky(Environment(with_sun(sun), filter, 15));
      for (const Vec3d& normal : {Vec3d{0, 1, 0}, Vec3d{0.8, 0, 0.6}, Vec3d{-0.48, -0.6, -0.64}}) {
        const double exact = summed(sky, normal);
        for (const SkyLighting way : sampled_ways) {
          CAPTURE(static_cast<int>(way));
          const Spread found =
              spread([&](Numbers& numbers) { return one_sample(way, sky, normal, numbers); });
          CHECK(found.mean ==
                doctest::Approx(exact).epsilon(5e-4 + 2.5 * std::sqrt(found.variance / 16384)));
        }
      }
    }
  }
}

TEST_CASE("an open can hides a part of the sky from its own inner side, in every way") {
  const std::vector<Painted<Coat, Cylinder>> can = {{.shape = {}, .paint = {{1, 1, 1}}}};
  const auto light = [&](SkyLighting way) {
    return spread([&](Numbers& numbers) {
             const Ray<double> ray{{0, 3, 0}, {1, -3, 0}};
             return light_under_sky(can, ray, constant_sky(1), {way}, 1, numbers).g;
           })
        .mean;
  };
  const double right = light(SkyLighting::cosine);
  CHECK(right < 0.7);  // a lone ball of this paint sends out 1
  CHECK(light(SkyLighting::mis) == doctest::Approx(right).epsilon(0.01));
}

TEST_CASE("mis draws by what is brighter than the mean; by all of a sky of one brightness") {
  LightImage halves(8, 4, gray(1.0F));
  for (int row = 0; row < 4; ++row)
    for (int column = 4; column < 8; ++column) halves.at(column, row) = gray(3.0F);
  const SkyLight sky(Environment(std::move(halves), TexelFilter::nearest));
  const double sphere = 4 * pi<double>();
  const auto left = sky.toward(Vec3d{0, 0, 1}),
             right = sky.toward(Vec3d{0, 0, -1});  // u = 1/4, 3/4
  CHECK(sky.density(true, left) == 0);
  CHECK(sky.density(true, right) == doctest::Approx(2 / sphere));
  CHECK(sky.density(false, left) == doctest::Approx(0.5 / sphere));
  CHECK(SkyLight(Environment(LightImage(8, 4, gray(0.7F)), TexelFilter::nearest))
            .density(true, left) == doctest::Approx(1 / sphere));
}

TEST_CASE("no sample of mis is a bright dot: the cosine and the sky each bound it") {
  const SkyLight sky(Environment(with_sun(1e4F), TexelFilter::nearest));
  const double mean = sky.sampler.total() / (4 * pi<double>());
  double most = 0;
  for (std::uint32_t i = 0; i < 4096; ++i) {
    Numbers numbers{{SamplerKind::random, 4096}, i};
    most = std::max(most, one_sample(SkyLighting::mis, sky, Vec3d{0, 1, 0}, numbers));
  }
  CHECK(most <= 2 * (mean + sky.above_mean.total() / pi<double>()));
  CHECK(most < 1e3);
}

TEST_CASE("a mirror shows the sky of the mirrored ray, times its color") {
  const SkyLight sky(Environment(with_sun(30)));
  const std::vector<Painted<Coat>> ball = {
      {.shape = {}, .paint = {{0.5, 0.25, 1}, true}},
      {.shape = {.center = {0, 0, 900}, .radius = 0.001}, .paint = {}}};
  for (double x = -0.9; x < 1; x += 0.3) {
    Numbers numbers{{SamplerKind::random, 1}, 0};
    const Ray<double> ray = {{x, 0.2, 5}, {0, 0, -1}};
    const Color<double> light = light_under_sky(ball, ray, sky, {SkyLighting::mis}, 50, numbers);
    const Vec3d n = {x, 0.2, std::sqrt(1 - x * x - 0.04)};
    const Vec3d mirrored = ray.direction - n * (2 * dot(n, ray.direction));
    const double expected = sky(Ray<double>{{}, mirrored}).r;
    CHECK(light.r == doctest::Approx(0.5 * expected).epsilon(1e-9));
    CHECK(light.g == doctest::Approx(0.25 * expected).epsilon(1e-9));
  }
}

TEST_CASE("mirrors throw light on matte balls only with caustics, and by chance alone") {
  const SkyLight sky(Environment(with_sun(5000)));
  std::vector<Painted<Coat>> balls = two_balls;
  balls[1].paint.mirrors = true;
  const Ray<double> ray = {{0.5, 0.3, -5}, {0, 0, 1}};
  const auto light = [&](bool caustics) {
    return spread([&](Numbers& numbers) {
      return light_under_sky(balls, ray, sky, {SkyLighting::mis, caustics}, 50, numbers).g;
    });
  };
  CHECK(light(true).variance > 2 * light(false).variance);
}

TEST_CASE("a path by mis in plain C++, as page 12 shows it, brings the same light") {
  const SkyLight sky(Environment(with_sun(1000), TexelFilter::bilinear, 15));
  std::vector<Painted<Coat>> balls = two_balls;
  balls[1].paint = {{0.5, 0.25, 1}, true};
  balls.push_back({.shape = {.center = {0, -101, 0}, .radius = 100}, .paint = {{0.75, 1, 0.5}}});
  for (std::uint32_t i = 0; i < 2048; ++i) {
    Numbers numbers{{SamplerKind::random, 2048}, i};
    Numbers same = numbers;
    const Vec3d target = {0.01 * (i % 256) - 0.8, 0.2 * (i / 256) - 1, 0};
    const Ray<double> ray = {{0.2, 0.1, 5}, normalize(target - Vec3d{0.2, 0.1, 5})};
    const Rgb light = light_under_sky(balls, ray, sky, {SkyLighting::mis}, 4, numbers);
    const Rgb plain = PlainSkyPath{balls, sky, same}.light(ray, 4);
    const double off = abs(light.r - plain.r) + abs(light.g - plain.g) + abs(light.b - plain.b);
    REQUIRE(off <= 1e-9 * (1 + light.g));
  }
}

}  // namespace texmap::test
