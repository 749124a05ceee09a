// Pictures of light for the tests of textures.
#pragma once
#include "support/dice.hpp"
#include "texture/light_image.hpp"

namespace texmap::test {

/// Every channel of every texel at random, from 0 to 1.
[[nodiscard]] inline LightImage light_noise(int width, int height, std::uint64_t seed = 3) {
  Dice dice(seed);
  LightImage image(width, height);
  for (Color<float>& texel : image.pixels) {
    for (float Color<float>::*channel : {&Color<float>::r, &Color<float>::g, &Color<float>::b})
      texel.*channel = static_cast<float>(dice.between(0, 1));
  }
  return image;
}

}  // namespace texmap::test
