// Pictures for the tests of comparing, made of whole numbers so that they are the same everywhere.
#pragma once
#include <algorithm>
#include <cstdint>

#include "texture/image.hpp"

namespace texmap::test {

/// Every channel of every pixel at random.
[[nodiscard]] inline Image noise(int width, int height, std::uint32_t seed) {
  Image image(width, height);
  std::uint32_t state = seed;
  const auto next = [&state] {
    state = state * 1664525u + 1013904223u;  // any generator would do
    return static_cast<std::uint8_t>(state >> 24);
  };
  for (Rgb8& pixel : image.pixels) {
    pixel.r = next();
    pixel.g = next();
    pixel.b = next();
  }
  return image;
}

/// Color ramps with a grid of thin lines, moved to the right by `shift` columns.
[[nodiscard]] inline Image ramps(int width, int height, int shift = 0) {
  Image image(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const int x = column - shift + 64;
      const bool line = x % 16 == 0 || row % 16 == 8;
      const int red = (x * 5) % 256, green = (row * 4) % 256, blue = (x * 2 + row * 3) % 256;
      image.at(column, row) =
          line ? Rgb8{250, 240, 20}
               : Rgb8{static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                      static_cast<std::uint8_t>(blue)};
    }
  }
  return image;
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

}  // namespace texmap::test
