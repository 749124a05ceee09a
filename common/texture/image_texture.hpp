// A picture as a texture.
#pragma once
#include <array>
#include <tuple>
#include <type_traits>
#include <utility>

#include "color.hpp"
#include "fetch.hpp"
#include "image.hpp"
#include "texel.hpp"
#include "uv.hpp"

namespace texmap {

/// Which way v runs over a picture, whose first row is at the top.
enum class VAxis {
  up,    ///< v = 0 is the bottom row
  down,  ///< v = 0 is the top row
};

/// What a texel's bytes are taken for; in the order of light_of_bytes' tables.
enum class TexelLight {
  encoded,  ///< the bytes as they are, / 255: what seeds without linear light do
  linear,   ///< amounts of light, by the sRGB curve that the file's bytes follow
  stb,      ///< amounts of light as seed 2 has them: by stb_image's power 2.2, kept in bytes, of which 184 of 256 remain
};

/// One table for each TexelLight, in its order.
template <class Number>
using LightTables = std::array<std::array<Number, 256>, 3>;

/// They for each number that a picture is drawn with.
using AllLightTables = std::tuple<LightTables<float>, LightTables<double>, LightTables<long double>>;
/// Computed when the program starts, so that nothing may ask for them before main.
extern const AllLightTables light_tables;

/// What every byte stands for: place b holds that of the byte b, 0 to 1.
///
/// @tparam Number  float, double or long double
/// Errors: none; each entry is the formula's, rounded by it. Not to be called before main.
template <class Number>
[[nodiscard]] const std::array<Number, 256>& light_of_bytes(TexelLight light) {
  return std::get<LightTables<Number>>(light_tables)[static_cast<std::size_t>(light)];
}

/// The column and the row of a texel, whole numbers counted from the left and from the top.
template <class Real>
struct TexelPlace {
  TexelNumber<Real> column, row;
};

/// The texel of a picture that holds (u, v).
///
/// The row is found first and then counted from the other end, so that every texel holds its lower edge on either axis.
/// @param width, height  of the picture, 1 to 2^24 texels
template <class Real>
[[nodiscard]] TexelPlace<Real> texel_place(const Uv<Real>& uv, int width, int height, VAxis v_axis, TexelRounding rounding) {
  const TexelNumber<Real> from_zero = texel_number(uv.v, height, rounding);
  return {texel_number(uv.u, width, rounding), v_axis == VAxis::down ? from_zero : TexelNumber<Real>(height - 1) - from_zero};
}

/// Three plain numbers of a table, such as a color's channels, for a texel.
///
/// @param table  as for look_up
template <class Real, class Table>
[[nodiscard]] std::array<Real, 3> look_up(const Table& table, const TexelPlace<Real>& place) {
  if constexpr (std::is_floating_point_v<Real>) {
    const auto entry = table(place.column, place.row);
    return {static_cast<Real>(entry[0]), static_cast<Real>(entry[1]), static_cast<Real>(entry[2])};
  } else {
    return look_up(table, place.column, place.row);
  }
}

/// The color of the texel that holds (u, v): no filter, so a texel seen close is a square.
struct ImageTexture {
  Image image;  ///< an empty one is black; load_image never gives one
  VAxis v_axis = VAxis::up;
  TexelRounding rounding = TexelRounding::floor;
  TexelLight light = TexelLight::encoded;

  /// Each channel is the texel's byte / 255, or the light that it stands for.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    if (image.pixels.empty()) return {Real(0), Real(0), Real(0)};
    const TexelPlace<Real> place = texel_place(uv, image.width, image.height, v_axis, rounding);
    return texel(place);
  }

 private:
  template <class Real>
  [[nodiscard]] Color<Real> texel(const TexelPlace<Real>& place) const {
    if constexpr (can_fetch<Real>) {
      if (image.pixels.size() > 1) return fetched_texel(place.column, place.row);
    }
    // For plain numbers and their packs bytes are a table too: each entry is the quotient, rounded. Others bound the division.
    if (light != TexelLight::encoded || std::is_floating_point_v<Real> || lanes<Real> != 1) {
      // Numbers of more digits make do with long double's.
      using Entry = std::conditional_t<std::is_floating_point_v<Scalar<Real>>, Scalar<Real>, long double>;
      const auto& levels = light_of_bytes<Entry>(light);
      const auto linear = look_up(
          [&](int x, int y) {
            const Rgb8& bytes = image.at(x, y);
            return std::array{levels[bytes.r], levels[bytes.g], levels[bytes.b]};
          },
          place);
      return {linear[0], linear[1], linear[2]};
    }
    const auto bytes = look_up(
        [&](int x, int y) {
          const Rgb8& at = image.at(x, y);
          return std::array{at.r, at.g, at.b};
        },
        place);
    return {bytes[0] / Real(255), bytes[1] / Real(255), bytes[2] / Real(255)};
  }

  /// The same, all lanes at once. Four bytes are read where three are needed, but at the last texel, where the fourth would lie
  /// behind the picture, from one byte before.
  template <class Real>
  [[nodiscard]] Color<Real> fetched_texel(const Real& column, const Real& row) const {
    using Integers = Bits<Real>;
    const Integers texel = bits_from_real(row) * static_cast<std::uint32_t>(image.width) + bits_from_real(column);
    const Integers place = texel * 3U;
    const Integers last = static_cast<std::uint32_t>(3 * image.pixels.size() - 4);
    const Integers four = fetch_four_bytes<Real, 1>(&image.pixels.data()->r, select_less(last, place, last, place));
    const Integers bytes = select_less(last, place, four >> 8, four);
    const Scalar<Real>* const levels = light_of_bytes<Scalar<Real>>(light).data();
    return {fetch<Real>(levels, bytes & 255U), fetch<Real>(levels, (bytes >> 8) & 255U),
            fetch<Real>(levels, (bytes >> 16) & 255U)};
  }
};

}  // namespace texmap
