// Texels in one word: the error of the roots of light in levels; they are the picture's texels.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/kernels/root_texture.hpp"
#include "math/srgb.hpp"
#include "support/dice.hpp"
#include "support/lanes.hpp"

namespace texmap::test {
namespace {

/// A texture of all bytes, one column for each: red, green and blue differ.
LightTexture all_bytes(TexelLight light) {
  Image image(256, 1);
  for (int byte = 0; byte < 256; ++byte) {
    image.at(byte, 0) = {static_cast<std::uint8_t>(byte), static_cast<std::uint8_t>(255 - byte),
                         static_cast<std::uint8_t>(byte ^ 0x55)};
  }
  return {{image}, light};
}

Uv<double> middle(int column) { return {(column + 0.5) / 256, 0.5}; }

double levels_apart(double a, double b) { return 255 * std::abs(srgb_encode(a) - srgb_encode(b)); }

TEST_CASE("no byte's light is off by more levels than stated, and some by most of it") {
  double worst = 0;
  for (const TexelLight light : {TexelLight::linear, TexelLight::encoded, TexelLight::stb}) {
    const LightTexture exact = all_bytes(light);
    const RootTexture roots(exact);
    for (int byte = 0; byte < 256; ++byte) {
      const Rgb is = roots(middle(byte));
      const Rgb should = exact(middle(byte));
      for (const double off : {levels_apart(is.r, should.r), levels_apart(is.g, should.g),
                               levels_apart(is.b, should.b)}) {
        CHECK(off <= RootTexture::worst_levels);
        worst = std::max(worst, off);
      }
    }
  }
  CHECK(worst > 0.8 * RootTexture::worst_levels);
}

TEST_CASE("the texels are those of the picture, on both axes and by both roundings") {
  Dice dice;
  Image image(37, 19);
  for (Rgb8& pixel : image.pixels) {
    pixel = {static_cast<std::uint8_t>(dice.bits()), static_cast<std::uint8_t>(dice.bits()),
             static_cast<std::uint8_t>(dice.bits())};
  }
  for (const VAxis axis : {VAxis::up, VAxis::down}) {
    for (const TexelRounding rounding : {TexelRounding::floor, TexelRounding::lecture}) {
      const LightTexture exact{{.image = image, .v_axis = axis, .rounding = rounding},
                               TexelLight::linear};
      const RootTexture roots(exact);
      for (int i = 0; i < 2000; ++i) {
        const Uv<double> uv{dice.between(-0.1, 1.1), dice.between(-0.1, 1.1)};
        const Rgb is = roots(uv);
        const Rgb should = exact(uv);
        REQUIRE(levels_apart(is.r, should.r) + levels_apart(is.g, should.g) +
                    levels_apart(is.b, should.b) <=
                3 * RootTexture::worst_levels);
      }
    }
  }
}

TEST_CASE_TEMPLATE("each lane of a pack reads what a plain number reads", T, float, double) {
  for (const VAxis axis : {VAxis::up, VAxis::down}) {
    LightTexture texture = all_bytes(TexelLight::linear);
    texture.v_axis = axis;
    check_lanes_of_texture<T>(RootTexture(texture));
  }
}

}  // namespace
}  // namespace texmap::test
