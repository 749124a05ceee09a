// Renders a picture: rays through its pixels, on many threads, with any number.
#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>

#include "engine/draw/inline_whole.hpp"
#include "engine/draw/kinds.hpp"
#include "engine/draw/settings.hpp"
#include "engine/draw/threads.hpp"
#include "engine/fast/srgb_kernel.hpp"
#include "math/color.hpp"
#include "number/dual.hpp"
#include "number/uint.hpp"
#include "scene/camera.hpp"
#include "texture/image.hpp"

namespace texmap {

/// Color channels as bytes: 255 times the value, cut off, as in the source documents.
///
/// @param channel  any number; below 0 and NaN give 0, above 1 gives 255
template <class Real>
[[nodiscard]] UInt<Real> bytes_of(const Real& channel) {
  const Real inside = clamp(channel, Real(0), Real(1));
  if constexpr (std::is_same_v<Scalar<Real>, float> || std::is_same_v<Scalar<Real>, double>) {
    // No product is rounded up to a whole number; docs/numerics.md proves it.
    return uint_from_real(inside * Real(255));
  } else {
    return bytes_of(static_cast<double>(inside));
  }
}
/// The same for one number.
[[nodiscard]] inline std::uint8_t byte_of(double value) {
  return static_cast<std::uint8_t>(bytes_of(value));
}

/// Where in its pixel a sample is: the first at the center, the others evenly spread, from the
/// center, each coordinate in [-0.5, 0.5) pixels.
/// Source: Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences" (2018), sequence R2.
struct PixelOffset {
  double column = 0, row = 0;
};
[[nodiscard]] inline PixelOffset pixel_offset(int sample) {
  // 1/g and 1/g^2 with g = 1.3247..., g^3 = g + 1.
  const double x = 0.5 + sample * 0.75487766624669276;
  const double y = 0.5 + sample * 0.56984029099805327;
  return {x - std::floor(x) - 0.5, y - std::floor(y) - 0.5};
}

/// The color of the ray through a place in the picture. A lesson that needs footprints gets a ray
/// with its derivatives by column and row; `spacing` is the distance of its samples, in pixels.
template <class Real, class Lesson>
[[nodiscard]] Color<Real> ray_color(const Lesson& lesson, const View<>& view, const Real& column,
                                    const Real& row, const Real& spacing) {
  static_assert(
      requires(Ray<Real> ray) {
        { lesson(ray) } -> std::same_as<Color<Real>>;
      },
      "a lesson is called with a Ray<Real>, from many threads, and returns a Color<Real>: is its "
      "operator() const, and is that what it says? Only with `.numbers = Numbers::only_double` in "
      "`about` may it have double in place of Real");
  if constexpr (std::derived_from<Lesson, ShowsMeanLight>) {
    if (lesson.needs_footprints()) {  // to know how (u, v) changes: for filters and bumps
      const Dual<Real> across{column, spacing, Real(0)};
      const Dual<Real> down{row, Real(0), spacing};
      const Color<Dual<Real>> color = lesson(ray_through(view, across, down));
      return {color.r.value, color.g.value, color.b.value};
    }
  }
  return lesson(ray_through(view, column, row));
}

/// Light as a color whose channels lie in the middle of their bytes, since those are cut off.
template <class Real>
[[nodiscard]] Color<Real> shown_light(const Color<Real>& light) {
  const auto shown = [](const Real& channel) {
    if constexpr (std::is_same_v<Scalar<Real>, Real> || (lanes<Real>) != 1) {
      return (srgb_byte_exact(channel) + Real(0.5)) * Real(1.0 / 255);
    } else {
      return srgb_encode(channel) + Real(0.5 / 255);  // an interval may span several bytes
    }
  };
  return {shown(light.r), shown(light.g), shown(light.b)};
}

/// The color of a pixel, or of a pack of neighboring pixels: the mean of its samples.
template <class Real, class Lesson>
[[nodiscard]] Color<Real> pixel_color(const Lesson& lesson, const View<>& view, const Real& column,
                                      const Real& row, int samples) {
  Color<Real> sum{};
  const Real spacing = Real(1 / std::sqrt(static_cast<double>(samples)));
  for (int i = 0; i < samples; ++i) {
    // Without this test the call would cost 2 % of a picture with one sample.
    const PixelOffset offset = i == 0 ? PixelOffset{} : pixel_offset(i);
    sum = sum +
          ray_color(lesson, view, column + Real(offset.column), row + Real(offset.row), spacing);
  }
  const Color<Real> mean = samples == 1 ? sum : sum * (Real(1) / Real(samples));
  if constexpr (std::derived_from<Lesson, ShowsMeanLight>) {
    return shown_light(mean);
  } else {
    return mean;
  }
}

/// The picture of `lesson` in `view`, the same for any number of threads.
///
/// @param lesson  called with a Ray<Real> from many threads, returns a Color<Real>
template <class Real, class Lesson>
[[nodiscard]] Image render(const Lesson& lesson, const View<>& view,
                           const RenderSettings& settings = {}) {
  // A pack has pixels of one row; with a mesh, of a block.
  static constexpr int size = static_cast<int>(lanes<Real>);
  static constexpr bool has_mesh = std::derived_from<Lesson, HasMesh>;
  static constexpr int high = !has_mesh || size < 4 ? 1 : size < 16 ? 2 : 4;
  static constexpr int wide = size / high;
  Image image(view.width, view.height);
  const auto draw_rows = [&](int top) {
    const int lines = std::min(high, view.height - top);
    const Real rows = from_lanes<Real>([first = static_cast<Scalar<Real>>(top)](std::size_t i) {
      const std::size_t below = i / wide;
      return first + static_cast<Scalar<Real>>(below);
    });
    for (int left = 0; left < view.width; left += wide) {
      const auto first = static_cast<Scalar<Real>>(left);
      const Real columns = from_lanes<Real>(
          [first](std::size_t i) { return first + static_cast<Scalar<Real>>(i % wide); });
      const Color<Real> color = pixel_color<Real>(lesson, view, columns, rows, settings.samples);
      const UInt<Real> pixels =
          bytes_of(color.r) | bytes_of(color.g) << 8 | bytes_of(color.b) << 16;
      // The last packs may reach beyond the picture.
      const int end = std::min(wide, view.width - left);
      for (int line = 0; line < lines; ++line) {
        for (int i = 0; i < end; ++i) {
          const std::uint32_t pixel =
              uint_lane<Real>(pixels, static_cast<std::size_t>(line * wide + i));
          image.at(left + i, top + line) = {static_cast<std::uint8_t>(pixel),
                                            static_cast<std::uint8_t>(pixel >> 8),
                                            static_cast<std::uint8_t>(pixel >> 16)};
        }
      }
    }
  };
  for_each_row((view.height + high - 1) / high, settings.threads, settings.progress,
               [&](int i) { inline_whole<Real>([&] { draw_rows(i * high); }); });
  return image;
}

}  // namespace texmap
