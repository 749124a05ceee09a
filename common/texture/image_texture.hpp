// A picture as a texture.
#pragma once
#include <utility>

#include "color.hpp"
#include "image.hpp"
#include "texel.hpp"
#include "uv.hpp"

namespace texmap {

/// Which way v runs over a picture, whose first row is at the top.
enum class VAxis {
  up,    ///< v = 0 is the bottom row
  down,  ///< v = 0 is the top row
};

/// The color of the texel that holds (u, v): no filter, so a texel seen close is a square.
struct ImageTexture {
  Image image;  ///< an empty one is black; load_image never gives one
  VAxis v_axis = VAxis::up;
  TexelRounding rounding = TexelRounding::floor;

  /// Each channel is the texel's byte / 255.
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
    const auto channel = [&](std::uint8_t Rgb8::*which) {
      return look_up([&](int x, int y) { return image.at(x, y).*which; }, column, row) / Real(255);
    };
    return {channel(&Rgb8::r), channel(&Rgb8::g), channel(&Rgb8::b)};
  }
};

}  // namespace texmap
