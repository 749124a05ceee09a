// Develops a film: from light to bytes.
#pragma once
#include <cmath>
#include <cstdint>

#include "engine/draw/film.hpp"
#include "engine/draw/render.hpp"
#include "engine/draw/transfer.hpp"
#include "engine/fast/srgb_kernel.hpp"

namespace texmap {

/// The byte of an amount of light, rounded to nearest; by Transfer::sqrt cut off, as in the books.
///
/// @param light  below 0 and NaN give 0, above 1 gives 255
[[nodiscard]] inline double byte_of_light(double light, Transfer transfer) {
  if (transfer == Transfer::srgb) return srgb_byte_exact(light);
  const double linear = clamp(light, 0.0, 1.0);
  if (transfer == Transfer::sqrt) return std::floor(256 * min(std::sqrt(linear), 0.999));
  return std::floor(255 * pow(linear, 1 / 2.2) + 0.5);
}

/// Develops a row of a picture. Equal neighbors, as in a uniform sky, are developed once.
inline void develop_row(const Rgb* light, Transfer transfer, Image& image, int row) {
  const auto byte = [transfer](double channel) {
    return static_cast<std::uint8_t>(byte_of_light(channel, transfer));
  };
  for (int column = 0; column < image.width; ++column) {
    const Rgb& at = light[column];
    const Rgb& last = light[column > 0 ? column - 1 : 0];
    const bool same = column > 0 && at.r == last.r && at.g == last.g && at.b == last.b;
    image.at(column, row) =
        same ? image.at(column - 1, row) : Rgb8{byte(at.r), byte(at.g), byte(at.b)};
  }
}

/// The picture of a film.
///
/// @param threads  0: all cores
[[nodiscard]] inline Image develop(const Film& film, Transfer transfer, int threads = 0) {
  Image image(film.width(), film.height());
  for_each_row(film.height(), threads, {},
               [&](int row) { develop_row(film.row(row), transfer, image, row); });
  return image;
}

}  // namespace texmap
