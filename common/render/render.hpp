// Draws a picture: rays through its pixels, many threads, any number.
#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <type_traits>

#include "bits.hpp"
#include "camera.hpp"
#include "color.hpp"
#include "compiler.hpp"
#include "image.hpp"
#include "instructions.hpp"
#include "progress.hpp"
#include "threads.hpp"

namespace texmap {

/// How a picture is drawn; nothing here changes what it shows, but for `samples`.
struct RenderSettings {
  int samples = 1;                                         ///< rays a pixel, at least 1
  int threads = 0;                                         ///< 0 takes all cores
  Instructions instructions = widest_instructions();       ///< that packs are made of, at most
  std::function<void(int done, int total)> progress = {};  ///< called after each finished row, from any thread
};

/// Color channels as bytes, by truncation of 255 times the value, as the seeds do.
///
/// @param channel  any number; below 0 and NaN give 0, above 1 gives 255
template <class Real>
[[nodiscard]] Bits<Real> bytes_of(const Real& channel) {
  const Real inside = clamp(channel, Real(0), Real(1));
  if constexpr (std::is_same_v<Scalar<Real>, float> || std::is_same_v<Scalar<Real>, double>) {
    // 255 times a float has more digits than a float, but no product is rounded up to a level k: for that, k / 255 would have
    // to lie less than 128/255 of the float's last digit above it. Its bits are those of k, repeated for ever, so that what
    // follows the first 24 begins with the highest bit of k: at least 128/255. (Below powers of two: 64/255.)
    return bits_from_real(inside * Real(255));
  } else {
    return bytes_of(static_cast<double>(inside));
  }
}
/// The same of one number.
[[nodiscard]] inline std::uint8_t byte_of(double value) { return static_cast<std::uint8_t>(bytes_of(value)); }

/// Where in its pixel a sample looks: the first at the center, the others spread evenly however many there are.
/// @return  offset from the pixel's center in pixels, each coordinate in [-0.5, 0.5)
/// Source: Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences" (2018), the sequence R2.
struct PixelOffset {
  double column = 0, row = 0;
};
[[nodiscard]] PixelOffset pixel_offset(int sample);

/// The color of one pixel (one pack of neighbouring pixels): the mean of its samples.
template <class Real, class Lesson>
[[nodiscard]] Color<Real> pixel_color(const Lesson& lesson, const View& view, const Real& column, const Real& row,
                                      int samples) {
  Color<Real> sum{};
  for (int i = 0; i < samples; ++i) {
    const PixelOffset offset = i == 0 ? PixelOffset{} : pixel_offset(i);  // a call at each pixel takes a fiftieth
    sum = sum + lesson(ray_through(view, column + Real(offset.column), row + Real(offset.row)));
  }
  return samples == 1 ? sum : sum * (Real(1) / Real(samples));
}

/// The picture that `lesson` shows in `view`.
///
/// @param lesson  callable with a Ray<Real>, gives a Color<Real>; called from many threads at once
/// The picture is the same for any number of threads: each pixel is computed alone.
template <class Real, class Lesson>
[[nodiscard]] Image render(const Lesson& lesson, const View& view, const RenderSettings& settings = {}) {
  constexpr int step = static_cast<int>(lanes<Real>);
  Image image(view.width, view.height);
  for_each_row(view.height, settings.threads, settings.progress, [&](int row) TEXMAP_FLATTEN {
    for (int column = 0; column < view.width; column += step) {
      const auto first = static_cast<Scalar<Real>>(column);
      const Real columns = from_lanes<Real>([first](std::size_t i) { return first + static_cast<Scalar<Real>>(i); });
      const Color<Real> color = pixel_color<Real>(lesson, view, columns, Real(row), settings.samples);
      const Bits<Real> pixels = bytes_of(color.r) | bytes_of(color.g) << 8 | bytes_of(color.b) << 16;
      // The last pack of a row may stick out of the picture.
      const int end = std::min(step, view.width - column);
      for (int i = 0; i < end; ++i) {
        const std::uint32_t pixel = lane_of<Real>(pixels, static_cast<std::size_t>(i));
        image.at(column + i, row) = {static_cast<std::uint8_t>(pixel), static_cast<std::uint8_t>(pixel >> 8),
                                     static_cast<std::uint8_t>(pixel >> 16)};
      }
    }
  });
  return image;
}

}  // namespace texmap
