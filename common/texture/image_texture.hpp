// An image as a texture, without a filter.
#pragma once
#include <array>
#include <type_traits>

#include "math/color.hpp"
#include "number/table.hpp"
#include "texture/image.hpp"
#include "texture/texel.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// Which way v runs over an image; the first row is at the top.
enum class VAxis {
  up,    ///< v = 0 is the bottom row
  down,  ///< v = 0 is the top row
};

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
  SharedImage image;  ///< an empty one is black
  VAxis v_axis = VAxis::up;
  TexelRounding rounding = TexelRounding::floor;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    if (image.pixels.empty()) return gray(Real(0));
    return texel_color(*this, texel_place(uv, image.width, image.height, v_axis, rounding));
  }
};

/// The color of a texel inside the image: each byte / 255.
template <class Real>
[[nodiscard]] Color<Real> texel_color(const ImageTexture& texture, const TexelPlace<Real>& place) {
  const auto bytes = look_up(
      [&](int column, int row) {
        const Rgb8& texel = texture.image.at(column, row);
        return std::array{texel.r, texel.g, texel.b};
      },
      place);
  return {bytes[0] / Real(255), bytes[1] / Real(255), bytes[2] / Real(255)};
}

}  // namespace texmap
