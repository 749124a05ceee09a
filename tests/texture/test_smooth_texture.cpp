// The smooth texture: a quadratic B-spline of an image.
#include "texture/smooth_texture.hpp"

#include <doctest.h>

#include <cmath>

#include "number/dual.hpp"
#include "support/made_pictures.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

Dual<double> with_slopes(const SmoothTexture& texture, double u, double v) {
  return texture(Uv<Dual<double>>{{u, 1, 0}, {v, 0, 1}}).r;
}

}  // namespace

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
