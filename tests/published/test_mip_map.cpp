// Tests of published/mip_map.hpp: where it is the course's trilinear filter. Where
// it fails, chapter 14 shows.
#include <doctest.h>

#include "published/mip_map.hpp"

namespace texmap::test {
namespace {

/// So many texels, the light of each its number.
FilteredTexture numbered(int width, int height) {
  LightImage image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = gray(static_cast<float>(i));
  return {.pyramid = pyramid_of(image), .filter = Filter::trilinear, .v_axis = VAxis::down};
}

/// A place with a pixel that covers so much of u and v.
Uv<Dual<double>> place(double u, double v, double along_u, double along_v) {
  return {{u, along_u, 0.0}, {v, 0.0, along_v}};
}

TEST_CASE("a square footprint of 2^k / 2 texels of a square picture reads level k") {
  const FilteredTexture texture = numbered(16, 16);
  const Uv<double> at{0.3, 0.6};
  for (int level = 0; level <= 4; ++level) {
    const double side = std::ldexp(0.5, level) / 16;
    const double found = published::trilinear(texture, place(at.u, at.v, side, side)).r;
    CHECK(std::abs(found - texture.bilinear(at, level_of(texture.pyramid, double(level))).r) <
          1e-9);
  }
  for (const double side : {0.0, 1e-30, 1e-4})
    CHECK(published::trilinear(texture, place(at.u, at.v, side, 0)).r == texture(at).r);
  for (const double side : {1.0, 1e30, infinity<double>()})
    CHECK(published::trilinear(texture, place(at.u, at.v, 0, side)).r == 127.5);
}

}  // namespace
}  // namespace texmap::test
