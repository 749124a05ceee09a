// Tests of common/texture/footprint.hpp and pyramid.hpp: what a pixel covers on a texture, and an
// image in the sizes to read it from. That a footprint's sides are in range whatever the
// derivatives, and how exact these are, tests/extremes searches.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "support/dice.hpp"
#include "support/made_pictures.hpp"
#include "texture/footprint.hpp"
#include "texture/pyramid.hpp"

namespace texmap::test {
namespace {

/// How far a footprint is from having the parallelogram's area and its spread in each direction,
/// in units of the spread. The parallelogram's sides are p and q.
double misfit(const Footprint<double>& footprint, double pu, double pv, double qu, double qv) {
  using Wide = long double;
  const Wide uu = Wide(pu) * pu + Wide(qu) * qu, vv = Wide(pv) * pv + Wide(qv) * qv;
  const Wide both = Wide(pu) * pv + Wide(qu) * qv;
  const Wide longer = footprint.longer, shorter = footprint.shorter;
  const Wide u = footprint.along_u / longer, v = footprint.along_v / longer;
  // The rectangle's spread: longer^2 along (u, v), shorter^2 across, along (-v, u).
  const Wide l = longer * longer, s = shorter * shorter;
  const Wide off = std::max({std::abs(l * u * u + s * v * v - uu),
                             std::abs(l * v * v + s * u * u - vv), std::abs((l - s) * u * v - both),
                             std::abs(longer * shorter - std::abs(Wide(pu) * qv - Wide(pv) * qu))});
  return static_cast<double>(off / (uu + vv));
}

TEST_CASE("the rectangle has the parallelogram's area and its spread in every direction") {
  Dice dice(9);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const double size = std::exp(dice.between(-12, 12));
    const auto any = [&] { return size * dice.between(-1, 1) * (dice.once_in(8) ? 0.001 : 1); };
    const double pu = any(), pv = any(), qu = any(), qv = any();
    const Uv<Dual<double>> moving{{0.5, pu, qu}, {0.5, pv, qv}};
    worst = std::max(worst, misfit(footprint_of(moving, 1.0, 1.0), pu, pv, qu, qv));
  }
  CHECK(worst < 1e-14);
}

Color<double> mean_of_level(const Pyramid& pyramid, std::size_t level) {
  const PyramidLevel<int>& size = pyramid.levels[level];
  Color<double> sum{};
  for (int row = 0; row < size.height; ++row) {
    for (int column = 0; column < size.width; ++column)
      sum = sum + texel_light<double>(pyramid, level_of(pyramid, static_cast<double>(level)),
                                      column, row);
  }
  return sum * (1.0 / (size.width * size.height));
}

TEST_CASE("every level of every size keeps the mean light, and the last level is it") {
  std::vector<std::pair<int, int>> sizes = {{1000, 3}, {1, 257}, {129, 1}, {96, 54}};
  for (int width = 1; width <= 17; ++width) {
    for (int height = 1; height <= 17; ++height) sizes.emplace_back(width, height);
  }
  for (const auto& [width, height] : sizes) {
    const int w = width, h = height;
    CAPTURE(w);
    CAPTURE(h);
    const Pyramid pyramid = pyramid_of(light_noise(w, h));
    const Color<double> mean = mean_of_level(pyramid, 0);
    for (std::size_t level = 0; level < pyramid.levels.size(); ++level) {
      const Color<double> here = mean_of_level(pyramid, level);
      CHECK(std::abs(here.r - mean.r) < 2e-7);
      CHECK(std::abs(here.g - mean.g) < 2e-7);
      CHECK(std::abs(here.b - mean.b) < 2e-7);
      CHECK(pyramid.levels[level].width == std::max(w >> level, 1));
      CHECK(pyramid.levels[level].height == std::max(h >> level, 1));
    }
    CHECK(pyramid.levels.back().width * pyramid.levels.back().height == 1);
  }
}

TEST_CASE(
    "each texel is the mean of four; of an odd size the middle one counts half on either side") {
  LightImage image(4, 2);
  for (int i = 0; i < 8; ++i) image.pixels[static_cast<std::size_t>(i)].r = static_cast<float>(i);
  const Pyramid half = pyramid_of(image);
  CHECK(half.at(0, 2).r == 2.5F);  // of 0, 1, 4, 5
  CHECK(half.at(1, 2).r == 4.5F);
  LightImage odd(5, 1);
  odd.at(2, 0).r = 5.0F;
  CHECK(pyramid_of(odd).at(0, 1).r == 1.0F);
  CHECK(pyramid_of(odd).at(1, 1).r == 1.0F);
  CHECK(pyramid_of(LightImage{}).last_level() == -1);
}

}  // namespace
}  // namespace texmap::test
