// Tests of common/texture/bilinear.hpp and smooth_texture.hpp: the filter between texels, and the
// quadratic B-spline of an image.
#include <doctest.h>

#include <cmath>
#include <limits>

#include "number/dual.hpp"
#include "support/made_pictures.hpp"
#include "texture/bilinear.hpp"
#include "texture/smooth_texture.hpp"

namespace texmap::test {
namespace {

/// The filter by another formula: all texels, weighted by their centers' distance in u and in v.
Rgb weighed(const Image& image, VAxis axis, long double u, long double v) {
  long double sum[3] = {0, 0, 0};
  const long double y = std::clamp(v * image.height, 0.5L, image.height - 0.5L);
  for (int row = 0; row < image.height; ++row) {
    const long double center = axis == VAxis::down ? row + 0.5L : image.height - row - 0.5L;
    const long double down = std::max(0.0L, 1 - std::abs(y - center));
    for (int column = 0; column < image.width; ++column) {
      long double weight = 0;  // a picture two texels wide meets itself on both sides
      for (int turn = -2; turn <= 2; ++turn) {
        weight += std::max(0.0L, 1 - std::abs((u + turn) * image.width - (column + 0.5L)));
      }
      const Rgb8& texel = image.at(column, row);
      sum[0] += weight * down * texel.r;
      sum[1] += weight * down * texel.g;
      sum[2] += weight * down * texel.b;
    }
  }
  return {static_cast<double>(sum[0] / 255), static_cast<double>(sum[1] / 255),
          static_cast<double>(sum[2] / 255)};
}

template <class T>
double apart(const Color<T>& a, const Rgb& b) {
  const auto off = [](T x, double y) {
    return static_cast<double>(std::abs(static_cast<long double>(x) - y));
  };
  return std::max({off(a.r, b.r), off(a.g, b.g), off(a.b, b.b)});
}

TEST_CASE_TEMPLATE(
    "the filter is the sum of all texels weighed by how near their centers are; u repeats, v ends",
    T, float, double) {
  const double bound = 4.0 * static_cast<double>(unit_roundoff<T>());
  for (const auto& [width, height] :
       {std::pair{1, 3}, std::pair{2, 2}, std::pair{3, 5}, std::pair{33, 16}}) {
    const Image image = noise(width, height, 1);
    for (const VAxis axis : {VAxis::up, VAxis::down}) {
      const BilinearTexture texture{image, axis};
      for (int i = 0; i < 400; ++i) {
        const T u = static_cast<T>((i * 67 + 3) % 1203 - 401) / T(401);
        const T v = static_cast<T>((i * 113 + 7) % 597 - 100) / T(396);
        const Color<T> color = texture(Uv<T>{u, v});
        // A place 2 roundoffs off is a color off by as many roundoffs of the texels in a unit.
        const double off = apart(
            color, weighed(image, axis, static_cast<long double>(u), static_cast<long double>(v)));
        CAPTURE(image.width);
        CAPTURE(i);
        REQUIRE(off <= bound + 4 * static_cast<double>(unit_roundoff<T>()) * (width + height));
      }
    }
  }
}

TEST_CASE("the mean of black and white is the middle of the light, not of the bytes") {
  Image image(2, 1);
  image.at(1, 0) = {255, 255, 255};
  CHECK(BilinearTexture{image, VAxis::up, TexelLight::linear}(Uv<double>{0.5, 0.5}).r == 0.5);
  CHECK(BilinearTexture{image, VAxis::up, TexelLight::linear}(Uv<double>{0.75, 0.5}).g == 1.0);
  CHECK(BilinearTexture{}(Uv<double>{0.5, 0.5}).r == 0);
}

TEST_CASE("what is no place counts as 0: u if it is infinite or no number, v if it is no number") {
  const BilinearTexture texture{noise(3, 4, 2)};
  const double none = infinity<double>(), nan = std::numeric_limits<double>::quiet_NaN();
  const auto green = [&](double u, double v) { return texture(Uv<double>{u, v}).g; };
  for (const double u : {none, -none, nan}) CHECK(green(u, 0.4) == green(0, 0.4));
  CHECK(green(0.3, nan) == green(0.3, 0));
  CHECK(green(0.3, none) == green(0.3, 1));
}

Dual<double> with_slopes(const SmoothTexture& texture, double u, double v) {
  return texture(Uv<Dual<double>>{{u, 1, 0}, {v, 0, 1}}).r;
}

TEST_CASE("a ramp of texels is a ramp, with its slope") {
  const auto ramp = [](int column, int row) {
    return gray(static_cast<float>(3 * (column + 0.5) / 16 - 2 * (7.5 - row) / 8));
  };
  const SmoothTexture texture{image_of(16, 8, ramp), VAxis::up, Wrap::clamp};
  Dice dice(2);
  for (int i = 0; i < 1000; ++i) {
    const double u = dice.between(0.1, 0.9), v = dice.between(0.2, 0.8);
    const Dual<double> height = with_slopes(texture, u, v);
    CHECK(height.value == doctest::Approx(3 * u - 2 * v).epsilon(1e-6));
    CHECK(height.dx == doctest::Approx(3).epsilon(1e-5));
    CHECK(height.dy == doctest::Approx(-2).epsilon(1e-5));
  }
}

TEST_CASE("value and slopes do not jump from texel to texel, over the seam and over the poles") {
  const SmoothTexture texture{light_noise(8, 4, 3)};
  const double tiny = 1e-9;
  Dice dice(4);
  for (int i = 0; i < 400; ++i) {
    const double u = dice.within(0, 8) / 8.0;  // an edge between texels; 0 and 1 are the seam
    const double v = dice.between(0, 1);
    const Dual<double> left = with_slopes(texture, u - tiny, v);
    const Dual<double> right = with_slopes(texture, u + tiny, v);
    CHECK(std::abs(left.value - right.value) < 1e-7);
    CHECK(std::abs(left.dx - right.dx) < 1e-6);
    CHECK(std::abs(left.dy - right.dy) < 1e-6);
  }
  for (int i = 0; i < 400; ++i) {
    const double u = dice.between(0, 0.5);
    const double pole = dice.once_in(2) ? tiny : 1 - tiny;
    const Dual<double> here = with_slopes(texture, u, pole);
    const Dual<double> beyond = with_slopes(texture, u + 0.5, pole);
    CHECK(std::abs(here.value - beyond.value) < 1e-7);
    CHECK(std::abs(here.dx - beyond.dx) < 1e-6);
    CHECK(std::abs(here.dy + beyond.dy) < 1e-6);  // v turns back
  }
}

TEST_CASE("a NaN reads a texel of the image, and an empty image is black") {
  const SmoothTexture texture{light_noise(8, 4, 5)};
  const double nan = std::nan("");
  CHECK(std::isnan(texture(Uv<double>{nan, nan}).r));
  CHECK(SmoothTexture{}(Uv<double>{0.5, 0.5}).r == 0);
}

}  // namespace
}  // namespace texmap::test
