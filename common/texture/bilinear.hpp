// The bilinear filter, and an image as a texture with it.
#pragma once
#include "number/table.hpp"
#include "texture/bilinear_mix.hpp"
#include "texture/light_image.hpp"
#include "texture/wrap.hpp"

namespace texmap {

/// The color at (u, v), mixed from the four nearest texel centers, u = (column + 1/2) / width.
/// u wraps around, so a globe has no seam; v is clamped to the first and the last row.
struct BilinearTexture {
  SharedImage image;  ///< an empty one is black
  VAxis v_axis = VAxis::up;
  TexelLight light = TexelLight::encoded;  ///< what is mixed; only linear light has a correct mean
  SharedLight deep{};                      ///< if not empty, finer numbers in place of the image

  /// The color at (u, v), exact at texel centers.
  ///
  /// @param uv  u any number, wrapped; v 0 to 1, clamped; NaN and infinite u count as 0
  /// Bound: 4 unit roundoffs of 1 for the color, 2 for the place.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    if (image.pixels.empty() && deep.empty()) return gray(Real(0));
    const Real width = Real(deep.empty() ? image.width : deep.width);
    const Real height = Real(deep.empty() ? image.height : deep.height);
    const Real x = wrapped_coordinate(Wrap::repeat, uv.u) * width - Real(0.5);
    const Real y = wrapped_coordinate(Wrap::clamp, uv.v) * height - Real(0.5);
    const auto texel_at = [&](const Real& column, const Real& row) {
      const Real beyond = select(column < width, Real(0), width);
      const Real last = height - Real(1), from_zero = clamp(row, Real(0), last);
      return texel(column - select(column < Real(0), -width, beyond),
                   v_axis == VAxis::down ? from_zero : last - from_zero);
    };
    return bilinear_mix(texel_at, x, y);
  }

 private:
  /// The texel in a column and a row from the top.
  template <class Real>
  [[nodiscard]] Color<Real> texel(const Real& column, const Real& row) const {
    if (!deep.empty()) return light_at(deep, column, row);
    const bool decoded = light != TexelLight::encoded;
    const auto* levels = decoded ? light_of_bytes<LightEntry<Real>>(light).data() : nullptr;
    const auto channels = look_up(
        [&](int at_column, int at_row) {
          const Rgb8& bytes = image.at(at_column, at_row);
          const auto level = [&](std::uint8_t byte) {
            return static_cast<Scalar<Real>>(decoded ? levels[byte]
                                                     : static_cast<LightEntry<Real>>(byte));
          };
          return std::array{level(bytes.r), level(bytes.g), level(bytes.b)};
        },
        column, row);
    const Real unit = Real(decoded ? 1 : 255);
    return {channels[0] / unit, channels[1] / unit, channels[2] / unit};
  }
};

}  // namespace texmap
