// Texels in one word: the error of the roots of light in levels; they are the picture's texels.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/kernels/root_texture.hpp"
#include "math/srgb.hpp"
#include "support/dice.hpp"

namespace texmap::test {
namespace {

/// A texture of all bytes, one texel for each: red, green and blue differ.
LightTexture all_bytes(TexelLight light) {
  Image image(32, 8);
  std::uint8_t byte = 0;
  for (Rgb8& pixel : image.pixels) {
    pixel = {byte, static_cast<std::uint8_t>(255 - byte), static_cast<std::uint8_t>(byte ^ 0x55)};
    ++byte;
  }
  return {{image}, light};
}

double levels_apart(double a, double b) { return 255 * std::abs(srgb_encode(a) - srgb_encode(b)); }

TEST_CASE(
    "texels are those of the picture, on both axes and by both roundings; none is off by more "
    "levels than stated, and some by most of it") {
  double worst = 0;
  Dice dice;
  for (const TexelLight light : {TexelLight::linear, TexelLight::encoded, TexelLight::stb}) {
    for (const VAxis axis : {VAxis::up, VAxis::down}) {
      for (const TexelRounding rounding : {TexelRounding::floor, TexelRounding::lecture}) {
        LightTexture exact = all_bytes(light);
        exact.v_axis = axis;
        exact.rounding = rounding;
        const RootTexture roots(exact);
        for (int i = 0; i < 8000; ++i) {
          const Uv<double> uv{dice.between(-0.1, 1.1), dice.between(-0.1, 1.1)};
          const Rgb is = roots(uv), should = exact(uv);
          worst = std::max({worst, levels_apart(is.r, should.r), levels_apart(is.g, should.g),
                            levels_apart(is.b, should.b)});
        }
      }
    }
  }
  CHECK(worst <= RootTexture::worst_levels);
  CHECK(worst > 0.8 * RootTexture::worst_levels);
}

}  // namespace
}  // namespace texmap::test
