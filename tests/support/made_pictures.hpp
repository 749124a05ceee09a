// Pictures for tests, made of whole numbers so that they are the same everywhere; and of light.
#pragma once
#include <algorithm>

#include "support/dice.hpp"
#include "texture/image.hpp"
#include "texture/light_image.hpp"

namespace texmap::test {

/// Every channel of every pixel at random.
[[nodiscard]] inline Image noise(int width, int height, std::uint32_t seed) {
  Image image(width, height);
  std::uint32_t state = seed;
  const auto next = [&state] {
    state = state * 1664525u + 1013904223u;  // any generator would do
    return static_cast<std::uint8_t>(state >> 24);
  };
  for (Rgb8& pixel : image.pixels) pixel = {next(), next(), next()};
  return image;
}

/// Color ramps with a grid of thin lines, moved to the right by `shift` columns.
[[nodiscard]] inline Image ramps(int width, int height, int shift = 0) {
  return image_of(width, height, [shift](int column, int row) -> Rgb8 {
    const int x = column - shift + 64;
    if (x % 16 == 0 || row % 16 == 8) return {250, 240, 20};
    return {static_cast<std::uint8_t>(x * 5), static_cast<std::uint8_t>(row * 4),
            static_cast<std::uint8_t>(x * 2 + row * 3)};
  });
}

/// With every channel up to `levels` off, at random.
[[nodiscard]] inline Image with_noise(Image image, int levels, std::uint32_t seed) {
  const Image random = noise(image.width, image.height, seed);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    for (const auto channel : {&Rgb8::r, &Rgb8::g, &Rgb8::b}) {
      const int off = random.pixels[i].*channel % (2 * levels + 1) - levels;
      image.pixels[i].*channel =
          static_cast<std::uint8_t>(std::clamp(image.pixels[i].*channel + off, 0, 255));
    }
  }
  return image;
}

/// Every channel of every texel at random, from 0 to 1.
[[nodiscard]] inline LightImage light_noise(int width, int height, std::uint64_t seed = 3) {
  Dice dice(seed);
  LightImage image(width, height);
  const auto any = [&] { return static_cast<float>(dice.between(0, 1)); };
  for (Color<float>& texel : image.pixels) texel = {any(), any(), any()};
  return image;
}

}  // namespace texmap::test
