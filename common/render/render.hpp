// Draws a picture: rays through its pixels, many threads, any number.
#pragma once
#include <cstdint>
#include <functional>

#include "camera.hpp"
#include "color.hpp"
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

/// A color channel as a byte, by truncation of 255 times the value, as the seeds do.
///
/// @param value  any number; below 0 and NaN give 0, above 1 gives 255
[[nodiscard]] inline std::uint8_t byte_of(double value) { return static_cast<std::uint8_t>(clamp(value, 0.0, 1.0) * 255); }

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
    const PixelOffset offset = pixel_offset(i);
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
  for_each_row(view.height, settings.threads, settings.progress, [&](int row) {
    for (int column = 0; column < view.width; column += step) {
      const auto first = static_cast<Scalar<Real>>(column);
      const Real columns = from_lanes<Real>([first](std::size_t i) { return first + static_cast<Scalar<Real>>(i); });
      const Color<Real> color = pixel_color<Real>(lesson, view, columns, Real(row), settings.samples);
      const auto r = all_lanes(color.r);
      const auto g = all_lanes(color.g);
      const auto b = all_lanes(color.b);
      // The last pack of a row may stick out of the picture.
      for (int i = 0; i < step && column + i < view.width; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const auto byte = [](Scalar<Real> channel) { return byte_of(static_cast<double>(channel)); };
        image.at(column + i, row) = {byte(r[at]), byte(g[at]), byte(b[at])};
      }
    }
  });
  return image;
}

}  // namespace texmap
