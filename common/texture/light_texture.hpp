// An image as a texture whose bytes mean amounts of light.
#pragma once
#include <array>
#include <tuple>
#include <type_traits>
#include <utility>

#include "number/table.hpp"
#include "texture/image_texture.hpp"

namespace texmap {

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

/// An ImageTexture whose bytes are decoded to light.
struct LightTexture : ImageTexture {
  TexelLight light;

  LightTexture(ImageTexture texture = {}, TexelLight meaning = TexelLight::linear)
      : ImageTexture(std::move(texture)), light(meaning) {}

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    if (image.pixels.empty()) return gray(Real(0));
    return texel_color(*this, texel_place(uv, image.width, image.height, v_axis, rounding));
  }
};

/// The light of a texel inside the image: what each of its bytes means.
template <class Real>
[[nodiscard]] Color<Real> texel_color(const LightTexture& texture, const TexelPlace<Real>& place) {
  // Not by the table: intervals and 50-digit numbers need byte / 255 without its rounding.
  if (texture.light == TexelLight::encoded)
    return texel_color(static_cast<const ImageTexture&>(texture), place);
  const auto& light = light_of_bytes<LightEntry<Real>>(texture.light);
  const auto channels = look_up(
      [&](int column, int row) {
        const Rgb8& texel = texture.image.at(column, row);
        return std::array{light[texel.r], light[texel.g], light[texel.b]};
      },
      place);
  return {channels[0], channels[1], channels[2]};
}

}  // namespace texmap
