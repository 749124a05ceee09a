// Certainty maps: which pixels of a picture rounding could change.
#pragma once
#include <algorithm>
#include <vector>

#include "engine/draw/render.hpp"
#include "number/kinds/interval.hpp"

namespace texmap {

/// The widest bound of a color's three channels, in levels; 0 where the bytes are certain.
[[nodiscard]] inline int uncertain_levels(const Color<Interval>& color) {
  int widest = 0;
  for (const Interval* channel : {&color.r, &color.g, &color.b})
    widest = std::max(widest, byte_of(channel->high()) - byte_of(channel->low()));
  return widest;
}

/// A pixel of the map: the picture in gray where it is certain; yellow for one uncertain level,
/// through red, to violet for 255.
[[nodiscard]] inline Rgb8 shade_of_uncertainty(const Color<Interval>& color, int levels) {
  if (levels == 0) {
    const double light = 0.3 * color.r.low() + 0.6 * color.g.low() + 0.1 * color.b.low();
    const auto shade = static_cast<std::uint8_t>(40 + clamp(light, 0.0, 1.0) * 200);
    return {shade, shade, shade};
  }
  const double t = log1p(levels - 1.0) / log1p(255.0);
  const Rgb low{1, 0.85, 0.1}, middle{0.85, 0.1, 0.1}, high{0.45, 0.1, 0.7};
  const Rgb shade = t < 0.5 ? mix(low, middle, 2 * t) : mix(middle, high, 2 * t - 1);
  return {byte_of(shade.r), byte_of(shade.g), byte_of(shade.b)};
}

/// The certainty map of a lesson, from its own code run with intervals. An uncertain pixel is drawn
/// three wide: alone it would not be seen. `settings.certainty` gets the number of pixels.
/// Double and every number with more digits draw each pixel within its bounds.
template <class Lesson>
[[nodiscard]] Image draw_certainty_map(const Lesson& lesson, const View<>& view,
                                       const RenderSettings& settings) {
  Image image(view.width, view.height);
  std::vector<std::uint8_t> levels(image.pixels.size());
  for_each_row(view.height, settings.threads, settings.progress, [&](int row) {
    for (int column = 0; column < view.width; ++column) {
      const auto color =
          pixel_color<Interval>(lesson, view, Interval(column), Interval(row), settings.samples);
      Rgb8& pixel = image.at(column, row);
      pixel = shade_of_uncertainty(color, 0);
      levels[static_cast<std::size_t>(&pixel - image.pixels.data())] =
          static_cast<std::uint8_t>(uncertain_levels(color));
    }
  });
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      std::uint8_t widest = 0;
      for (int y = std::max(row - 1, 0); y <= std::min(row + 1, view.height - 1); ++y) {
        const auto at = levels.begin() + static_cast<std::ptrdiff_t>(y) * view.width;
        widest = std::max(widest, *std::max_element(at + std::max(column - 1, 0),
                                                    at + std::min(column + 2, view.width)));
      }
      if (widest > 0) image.at(column, row) = shade_of_uncertainty({}, widest);
    }
  }
  if (settings.certainty) {
    const auto certain = std::count(levels.begin(), levels.end(), 0);
    settings.certainty(static_cast<long>(levels.size()) - static_cast<long>(certain),
                       static_cast<long>(levels.size()));
  }
  return image;
}

}  // namespace texmap
