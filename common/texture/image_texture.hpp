// An image as a texture, without a filter.
#pragma once
#include <array>
#include <tuple>
#include <type_traits>

#include "math/color.hpp"
#include "texture/image.hpp"
#include "texture/texel.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// Which way v runs over an image; the first row is at the top.
enum class VAxis {
  up,    ///< v = 0 is the bottom row
  down,  ///< v = 0 is the top row
};

/// What a texel's bytes mean, in the order of `light_tables`.
enum class TexelLight {
  encoded,  ///< the byte / 255, without linear light
  linear,   ///< an amount of light, by the sRGB curve of image files
  stb,      ///< stb_image's power 2.2, kept in 8 bits as in Next Week: 184 of 256 values remain
};

/// The meaning of every byte, 0 to 1: one table for each TexelLight.
template <class Number>
using LightTables = std::array<std::array<Number, 256>, 3>;
extern const std::tuple<LightTables<float>, LightTables<double>, LightTables<long double>>
    light_tables;

/// The table of one TexelLight, in float, double or long double.
template <class Number>
[[nodiscard]] const std::array<Number, 256>& light_of_bytes(TexelLight light) {
  return std::get<LightTables<Number>>(light_tables)[static_cast<std::size_t>(light)];
}

/// The entries of the table that a number reads: the widest for numbers without one of their own.
template <class Real>
using LightEntry =
    std::conditional_t<std::is_floating_point_v<Scalar<Real>>, Scalar<Real>, long double>;

/// A texel's column from the left and row from the top, whole numbers from 0.
template <class Real>
struct TexelPlace {
  TexelNumber<Real> column, row;
};

/// The texel that holds (u, v), in an image of 1 to 2^24 texels each way.
/// The row is found from v = 0 and then counted from the top: a texel holds its edge toward v = 0.
template <class Real>
[[nodiscard]] TexelPlace<Real> texel_place(const Uv<Real>& uv, int width, int height, VAxis v_axis,
                                           TexelRounding rounding) {
  const TexelNumber<Real> from_zero = texel_number(uv.v, height, rounding);
  return {texel_number(uv.u, width, rounding),
          v_axis == VAxis::down ? from_zero : TexelNumber<Real>(height - 1) - from_zero};
}

/// Three plain numbers of a table, such as color channels, for a texel.
///
/// @param table  called with a column and a row, returns an array of three
template <class Real, class Table>
[[nodiscard]] std::array<Real, 3> look_up(const Table& table, const TexelPlace<Real>& place) {
  if constexpr (std::is_floating_point_v<Real>) {
    const auto entry = table(place.column, place.row);
    return {static_cast<Real>(entry[0]), static_cast<Real>(entry[1]), static_cast<Real>(entry[2])};
  } else {
    return look_up(table, place.column, place.row);
  }
}

/// The color of the texel that holds (u, v): the nearest texel.
struct ImageTexture {
  Image image;  ///< an empty one is black
  VAxis v_axis = VAxis::up;
  TexelRounding rounding = TexelRounding::floor;
  TexelLight light = TexelLight::encoded;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    if (image.pixels.empty()) return gray(Real(0));
    return texel_color(*this, texel_place(uv, image.width, image.height, v_axis, rounding));
  }
};

/// The color of a texel inside the image: what each of its bytes means.
template <class Real>
[[nodiscard]] Color<Real> texel_color(const ImageTexture& texture, const TexelPlace<Real>& place) {
  // Intervals and 50-digit numbers compute byte / 255 themselves: a table entry is rounded.
  constexpr bool table_is_exact_enough = std::is_floating_point_v<Real> || lanes<Real> != 1;
  if (table_is_exact_enough || texture.light != TexelLight::encoded) {
    const auto& light = light_of_bytes<LightEntry<Real>>(texture.light);
    const auto channels = look_up(
        [&](int column, int row) {
          const Rgb8& texel = texture.image.at(column, row);
          return std::array{light[texel.r], light[texel.g], light[texel.b]};
        },
        place);
    return {channels[0], channels[1], channels[2]};
  }
  const auto bytes = look_up(
      [&](int column, int row) {
        const Rgb8& texel = texture.image.at(column, row);
        return std::array{texel.r, texel.g, texel.b};
      },
      place);
  return {bytes[0] / Real(255), bytes[1] / Real(255), bytes[2] / Real(255)};
}

}  // namespace texmap
