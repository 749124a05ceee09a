// Develops a film: from light to bytes.
#pragma once
#include <cmath>
#include <cstdint>
#include <functional>

#include "engine/kernels/srgb_kernel.hpp"
#include "engine/render/film.hpp"
#include "engine/render/render.hpp"
#include "engine/render/transfer.hpp"

namespace texmap {

/// The byte of an amount of light, rounded to nearest; by Transfer::sqrt cut off, as in the books.
///
/// @param light  below 0 and NaN give 0, above 1 gives 255
[[nodiscard]] inline double byte_of_light(double light, Transfer transfer) {
  const double linear = clamp(light, 0.0, 1.0);
  if (transfer == Transfer::sqrt) return std::floor(256 * min(std::sqrt(linear), 0.999));
  if (transfer == Transfer::stb) return std::floor(255 * std::pow(linear, 1 / 2.2) + 0.5);
  return srgb_byte_exact(linear);
}

/// The picture of a film.
///
/// @param threads   0: all cores
/// @param finished  as for for_each_row
[[nodiscard]] inline Image develop(const Film& film, Transfer transfer, int threads = 0,
                                   const std::function<void(int, int)>& finished = {}) {
  Image image(film.width(), film.height());
  for_each_row(film.height(), threads, finished, [&](int row) {
    for (int column = 0; column < film.width(); ++column) {
      const auto byte = [transfer](double light) {
        return static_cast<std::uint8_t>(byte_of_light(light, transfer));
      };
      const Rgb light = film.light(column, row);
      image.at(column, row) = {byte(light.r), byte(light.g), byte(light.b)};
    }
  });
  return image;
}

}  // namespace texmap
