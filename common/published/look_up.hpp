// An image under any (u, v): wrapped, or read as a source document prints it.
#pragma once
#include "published/uv.hpp"
#include "texture/image_texture.hpp"
#include "texture/wrapped.hpp"

namespace texmap::published {

/// From (u, v) to a texel. To add one, name it here: the compiler asks for the rest.
enum class TexelFormula {
  course,            ///< a wrap mode, then the image's own rounding
  one_weekend_2020,  ///< column and row are kept inside the image
  triangle_article,  ///< |(int)(u n)| mod n
};

/// How a texture is read beyond its edges.
struct LookUp {
  Wrap wrap = Wrap::repeat;  ///< of the course's formula
  TexelFormula formula = TexelFormula::course;

  bool operator==(const LookUp&) const = default;
};

/// An image as a texture for any (u, v).
struct LookUpTexture {
  Wrapped<ImageTexture> wrapped;
  TexelFormula formula = TexelFormula::course;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    const ImageTexture& image = wrapped.texture;
    const int columns = image.image.width, rows = image.image.height;
    if (image.image.pixels.empty()) return gray(Real(0));
    const TexelNumber<Real> last_row(rows - 1);
    const auto color = [&](const TexelNumber<Real>& column, const TexelNumber<Real>& from_zero) {
      const bool down = image.v_axis == VAxis::down;
      return texel_color(image, TexelPlace<Real>{column, down ? from_zero : last_row - from_zero});
    };
    switch (formula) {
      case TexelFormula::one_weekend_2020:
        return color(texel_number(uv.u, columns, TexelRounding::floor),
                     last_row - row_one_weekend_2020(uv.v, rows));
      case TexelFormula::triangle_article:
        return color(index_triangle(uv.u, columns), index_triangle(uv.v, rows));
      case TexelFormula::course:
        break;
    }
    return wrapped(uv);
  }
};

}  // namespace texmap::published
