// Tests of common/texture/sky_sampler.hpp, sky_texels.hpp: directions drawn where a sky is bright.
#include "texture/sky_sampler.hpp"

#include <doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sampling/samplers.hpp"

namespace texmap::test {
namespace {

constexpr double sphere = 4 * std::numbers::pi;

/// A sky with all brightnesses from 0 up, one texel much brighter than the others.
LightImage contrasts(int width, int height) {
  LightImage image(width, height);
  std::uint32_t state = 11;
  for (Color<float>& texel : image.pixels) {
    state = state * 1664525U + 1013904223U;
    const float brightness = state >> 31 == 0 ? 0.0F : static_cast<float>(state >> 8) * 0x1p-23F;
    texel = gray(brightness);
  }
  image.at(width / 3, height / 3) = gray(300.0F);
  return image;
}

/// Pair number `i` of `count` for one of three uses.
Point2<double> pair(std::uint32_t i, std::uint32_t count, std::uint32_t use) {
  return Sampler(SamplerKind::sobol, static_cast<int>(count))
      .pair<double>(hash_pixels<double>(1U, 2U), i, use);
}

/// The integral of a function over the sphere, by 40 x 40 places in each texel of a sky.
template <class Function>
double integral(const Environment& sky, const Function& function) {
  const int columns = 40 * sky.map().width, rows = 40 * sky.map().height;
  double sum = 0;
  for (int row = 0; row < rows; ++row) {
    const double v = (row + 0.5) / rows;
    const double sine = on_circle(v / 2).sine;
    for (int column = 0; column < columns; ++column) {
      const Vec3d on_map = direction_rtiow(Uv<double>{(column + 0.5) / columns, v});
      sum += sine * function(sky.from_map(on_map));
    }
  }
  return sum * 2 * std::numbers::pi * std::numbers::pi / columns / rows;
}

}  // namespace

TEST_CASE("the solid angles of all texels add up to the sphere, in maps of every height") {
  for (const int height : {1, 2, 3, 7, 64, 1000, 4096}) {
    CompensatedSum<double> sum;
    for (int row = 0; row < height; ++row) {
      const SkyBand band(row, 2 * height, height);
      sum.add(2 * height * band.solid_angle);
      const double of_edges = 2 * std::numbers::pi / (2 * height) * std::abs(band.to - band.from);
      CHECK(band.solid_angle == doctest::Approx(of_edges).epsilon(1e-9));
    }
    CHECK(sum.value() == doctest::Approx(sphere).epsilon(1e-14));
  }
  CHECK(SkySampler(Environment(LightImage(8, 4, gray(1.0F)))).total() == doctest::Approx(sphere));
}

TEST_CASE("by nearest texels a drawn direction lies in its texel, where the density is its own") {
  const Environment sky(contrasts(16, 8), TexelFilter::nearest);
  const SkySampler sampler(sky);
  int edges = 0;
  for (std::uint32_t i = 0; i < 4096; ++i) {
    const auto [d, uv] = sampler.direction(sky, pair(i, 4096, 1));
    REQUIRE(std::abs(length(d) - 1) < 1e-15);
    const auto row = static_cast<std::size_t>(8 - 8 * uv.v);
    const std::size_t texel = 16 * row + static_cast<std::size_t>(16 * uv.u);
    const double expected =
        static_cast<double>(sampler.probabilities()[texel]) / sampler.bands()[row].solid_angle;
    REQUIRE(sampler.density(d, uv) == expected);
    edges += std::abs(sampler.density(d, sky.uv_of(d)) / expected - 1) > 1e-14 ? 1 : 0;
  }
  CHECK(edges == 0);
}

TEST_CASE("the mean of f / density over drawn directions is the integral of f") {
  // f = light times (1 + y / 2 + x^2): each factor of the density counts.
  for (const TexelFilter filter : {TexelFilter::nearest, TexelFilter::bilinear}) {
    const Environment sky(contrasts(16, 8), filter, -70);
    const SkySampler sampler(sky);
    const auto f = [&](const Vec3d& d) {
      return sky(Ray<double>{{}, d}).r * (1 + d.y / 2 + d.x * d.x);
    };
    constexpr std::uint32_t count = 16384;
    double mean = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto [d, uv] = sampler.direction(sky, pair(i, count, 1));
      mean += f(d) / sampler.density(d, uv) / count;
    }
    CHECK(mean == doctest::Approx(integral(sky, f)).epsilon(2e-3));
  }
}

TEST_CASE("a tent that reaches over a pole comes down on the other side") {
  for (const int row : {0, 7}) {
    LightImage map(16, 8);
    map.at(5, row) = gray(1.0F);
    const Environment sky(map);
    const SkySampler sampler(sky);
    constexpr std::uint32_t count = 16384;
    double over = 0;
    const Vec3d middle = direction_rtiow(Uv<double>{5.5 / 16, 0.5});
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec3d d = sampler.direction(sky, pair(i, count, 1)).direction;
      over += dot(d, middle) < 0 ? 1.0 / count : 0;
    }
    CHECK(over == doctest::Approx(1.0 / 8).epsilon(0.01));  // half a texel of a tent two wide
  }
}

TEST_CASE("a black sky has no light and draws something") {
  const Environment sky(LightImage(4, 2));
  const SkySampler sampler(sky);
  CHECK(sampler.total() == 0);
  CHECK(sampler.density(Vec3d{1, 0, 0}, Uv<double>{0.5, 0.5}) == 0);
  CHECK(std::isfinite(sampler.direction(sky, Point2<double>{0.5, 0.5}).direction.x));
}

TEST_CASE("the order of texels holds each once, and keeps squares of 2^k texels together") {
  for (const auto& [width, height] : {std::array{1, 1}, {6, 5}, {384, 192}, {4096, 1}}) {
    const std::vector<std::uint32_t> order = z_order(width, height);
    std::vector<bool> met(static_cast<std::size_t>(width * height));
    for (const std::uint32_t texel : order) met[texel] = true;
    CHECK(order.size() == met.size());
    CHECK(std::find(met.begin(), met.end(), false) == met.end());
  }
  const std::vector<std::uint32_t> order = z_order(64, 64);
  for (std::size_t i = 0; i < order.size(); ++i) {
    CHECK(order[i] % 64 / 8 == order[i - i % 64] % 64 / 8);
    CHECK(order[i] / 64 / 8 == order[i - i % 64] / 64 / 8);
  }
}

}  // namespace texmap::test
