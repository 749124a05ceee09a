// Tests of common/texture/pyramid.hpp: an image in many sizes.
#include "texture/pyramid.hpp"

#include <doctest.h>

#include <cmath>

#include "support/made_pictures.hpp"

namespace texmap::test {
namespace {

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
  const LightImage half = halved(image);
  CHECK(half.at(0, 0).r == 2.5F);  // of 0, 1, 4, 5
  CHECK(half.at(1, 0).r == 4.5F);
  LightImage odd(5, 1);
  odd.at(2, 0).r = 5.0F;
  CHECK(halved(odd).at(0, 0).r == 1.0F);
  CHECK(halved(odd).at(1, 0).r == 1.0F);
  CHECK(pyramid_of(LightImage{}).last_level() == -1);
}

}  // namespace
}  // namespace texmap::test
