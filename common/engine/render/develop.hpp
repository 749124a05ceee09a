// Develops a film: from light to bytes.
#pragma once
#include <algorithm>
#include <functional>

#include "engine/kernels/srgb_kernel.hpp"
#include "engine/render/film.hpp"
#include "engine/render/render.hpp"
#include "engine/render/transfer.hpp"

namespace texmap {

/// The byte of an amount of light, rounded to nearest; by Transfer::sqrt cut off, as in the books.
///
/// @param light  any number; below 0 and NaN give 0, above 1 gives 255
/// @param terms  of the sRGB polynomial: 6 or 4 (one level off at most), 3 (two); 0: exact curve
template <class Real>
[[nodiscard]] Real byte_of_light(const Real& light, Transfer transfer, int terms = 0) {
  const Real linear = clamp(light, Real(0), Real(1));
  if (transfer == Transfer::sqrt) return floor(Real(256) * min(sqrt(linear), Real(0.999)));
  if (transfer == Transfer::stb) {
    return floor(Real(255) * power(linear, static_cast<Scalar<Real>>(1 / 2.2)) + Real(0.5));
  }
  return terms == 3   ? srgb_byte<3>(linear)
         : terms == 4 ? srgb_byte<4>(linear)
         : terms == 6 ? srgb_byte<6>(linear)
                      : srgb_byte_exact(linear);
}

/// The picture of a film.
///
/// @tparam Real     double or a pack of it, with the same result
/// @param terms     as for byte_of_light
/// @param threads   0: all cores
/// @param finished  as for for_each_row
template <class Real = double>
[[nodiscard]] Image develop(const Film& film, Transfer transfer, int terms = 0, int threads = 0,
                            const std::function<void(int, int)>& finished = {}) {
  Image image(film.width(), film.height());
  constexpr int step = static_cast<int>(lanes<Real>);
  for_each_row(film.height(), threads, finished, [&](int row) {
    for (int first = 0; first < film.width(); first += step) {
      const int count = std::min(step, film.width() - first);
      std::array<Rgb, lanes<Real>> light;
      for (int i = 0; i < step; ++i)
        light[static_cast<std::size_t>(i)] = film.light(first + std::min(i, count - 1), row);
      const auto bytes = [&](double Rgb::*channel) {
        const Real in_lanes = from_lanes<Real>(
            [&](std::size_t i) { return static_cast<Scalar<Real>>(light[i].*channel); });
        return all_lanes(byte_of_light(in_lanes, transfer, terms));
      };
      const auto r = bytes(&Rgb::r), g = bytes(&Rgb::g), b = bytes(&Rgb::b);
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        image.at(first + static_cast<int>(i), row) = {static_cast<std::uint8_t>(r[i]),
                                                      static_cast<std::uint8_t>(g[i]),
                                                      static_cast<std::uint8_t>(b[i])};
      }
    }
  });
  return image;
}

}  // namespace texmap
