// A picture as a texture.
#pragma once
#include <utility>

#include "color.hpp"
#include "image.hpp"
#include "srgb.hpp"
#include "texel.hpp"
#include "uv.hpp"

namespace texmap {

/// Which way v runs over a picture, whose first row is at the top.
enum class VAxis {
  up,    ///< v = 0 is the bottom row
  down,  ///< v = 0 is the top row
};

/// What a texel's bytes are taken for.
enum class TexelLight {
  encoded,  ///< the bytes as they are, / 255: what seeds without linear light do
  linear,   ///< amounts of light, by the sRGB curve that the file's bytes follow
  stb,      ///< amounts of light as seed 2 has them: by stb_image's power 2.2, kept in bytes, of which 184 of 256 remain
};

/// The amount of light of every byte.
///
/// @param light  linear or stb
template <class Number>
[[nodiscard]] const std::array<Number, 256>& light_of_bytes(TexelLight light) {
  static const std::array<Number, 256> by_stb = [] {
    std::array<Number, 256> table{};
    for (int byte = 0; byte < 256; ++byte) {
      const double decoded = std::pow(byte / 255.0, 2.2);
      table[static_cast<std::size_t>(byte)] = static_cast<Number>(std::min(std::floor(256 * decoded), 255.0) / 255);
    }
    return table;
  }();
  return light == TexelLight::stb ? by_stb : srgb_decode_table<Number>();
}

/// The color of the texel that holds (u, v): no filter, so a texel seen close is a square.
struct ImageTexture {
  Image image;  ///< an empty one is black; load_image never gives one
  VAxis v_axis = VAxis::up;
  TexelRounding rounding = TexelRounding::floor;
  TexelLight light = TexelLight::encoded;

  /// Each channel is the texel's byte / 255, or the light that it stands for.
  /// The row is found first and then counted from the other end, so that every texel holds its lower edge on either axis.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    if (image.pixels.empty()) return {Real(0), Real(0), Real(0)};
    const Real column = texel_index(uv.u, image.width, rounding);
    const Real from_zero = texel_index(uv.v, image.height, rounding);
    const Real row = v_axis == VAxis::down ? from_zero : Real(image.height - 1) - from_zero;
    return texel(column, row);
  }

 private:
  template <class Real>
  [[nodiscard]] Color<Real> texel(const Real& column, const Real& row) const {
    if (light != TexelLight::encoded) {
      const auto& levels = light_of_bytes<Scalar<Real>>(light);
      const auto linear = look_up(
          [&](int x, int y) {
            const Rgb8& bytes = image.at(x, y);
            return std::array{levels[bytes.r], levels[bytes.g], levels[bytes.b]};
          },
          column, row);
      return {linear[0], linear[1], linear[2]};
    }
    const auto bytes = look_up(
        [&](int x, int y) {
          const Rgb8& at = image.at(x, y);
          return std::array{at.r, at.g, at.b};
        },
        column, row);
    return {bytes[0] / Real(255), bytes[1] / Real(255), bytes[2] / Real(255)};
  }
};

}  // namespace texmap
