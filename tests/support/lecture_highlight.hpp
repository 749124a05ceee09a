// How many pixels of the lecture's globe the right highlight and the slides' brighten.
#pragma once
#include <cstddef>

#include "06_phong_texture_blend/lesson.hpp"
#include "support/pictures.hpp"
#include "support/running.hpp"

namespace texmap::test {

struct BrightenedPixels {
  long globe = 0;         ///< all pixels of the globe
  long in_the_light = 0;  ///< by Phong's highlight with exponent 100
  long in_the_dark = 0;   ///< by the slides' formula, where the lamp does not shine
};

/// Counts them in the lecture's scene without a texture.
[[nodiscard]] inline BrightenedPixels brightened_pixels() {
  const auto light_alone = [](const char* shininess, const char* formula) {
    return picture(prepared<chapter_06::Lesson>({"--scene", "lecture", "--blend", "0",
                                                 "--shininess", shininess, "--highlight", formula}),
                   800, 400);
  };
  const Image without = light_alone("1e30", "phong");
  const Image right = light_alone("100", "phong");
  const Image slides = light_alone("100", "lecture");
  BrightenedPixels count;
  for (std::size_t i = 0; i < without.pixels.size(); ++i) {
    const Rgb8 p = without.pixels[i];
    if (p.r != p.b || p.r == 0) continue;  // the ground is yellow, the sky black
    count.globe += 1;
    count.in_the_light += right.pixels[i] != p ? 1 : 0;
    count.in_the_dark += p.r == 51 && slides.pixels[i] != p ? 1 : 0;  // 51 is the ambient light
  }
  return count;
}

}  // namespace texmap::test
