// An image as a texture for packs: one 32-bit word a texel.
#pragma once
#include <cmath>
#include <cstdint>

#include "number/kinds/fetch.hpp"
#include "number/table.hpp"
#include "texture/light_texture.hpp"

namespace texmap {

/// The nearest texel, as LightTexture; a texel is one word, ten bits a channel for the square root
/// of its light, which is spread about as the eye sees it.
struct RootTexture {
  Grid<std::uint32_t> texels;  ///< red in the lowest bits
  VAxis v_axis = VAxis::up;
  TexelRounding rounding = TexelRounding::floor;

  static constexpr int most = 1023;  ///< of a channel: the root of 1

  /// Largest error in levels of 255 by the sRGB curve: half a step where levels are closest.
  static constexpr double worst_levels = 0.19;

  RootTexture() = default;
  explicit RootTexture(const LightTexture& texture)
      : v_axis(texture.v_axis), rounding(texture.rounding) {
    std::array<std::uint32_t, 256> roots{};
    for (std::size_t byte = 0; byte < roots.size(); ++byte) {
      roots[byte] = static_cast<std::uint32_t>(
          std::lround(most * std::sqrt(light_of_bytes<double>(texture.light)[byte])));
    }
    texels = image_of(texture.image.width, texture.image.height, [&](int column, int row) {
      const Rgb8& at = texture.image.at(column, row);
      return roots[at.r] | roots[at.g] << 10 | roots[at.b] << 20;
    });
  }

  /// @return  each channel 0 to 1. Domain: a texture with texels
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    const TexelPlace<Real> place = texel_place(uv, texels.width, texels.height, v_axis, rounding);
    const auto light = [](const Real& root) { return square(root * Real(1.0 / most)); };
    if constexpr (can_fetch<Real>) {
      using Integers = UInt<Real>;
      const Integers index = uint_from_real(place.row) * static_cast<std::uint32_t>(texels.width) +
                             uint_from_real(place.column);
      const Integers word = fetch_four_bytes<Real, 4>(texels.pixels.data(), index);
      const auto channel = [&](const Integers& bits) {
        return light(real_from_uint<Real>(bits & std::uint32_t{most}));
      };
      return {channel(word), channel(word >> 10), channel(word >> 20)};
    }
    const auto roots = look_up(
        [&](int column, int row) {
          const std::uint32_t word = texels.at(column, row);
          return std::array{word & most, word >> 10 & most, word >> 20 & most};
        },
        place);
    return {light(roots[0]), light(roots[1]), light(roots[2])};
  }
};

}  // namespace texmap
