// Light as the channels of a picture.
#pragma once
#include "math/color.hpp"

namespace texmap {

/// A channel of light by the sRGB curve of image files, exactly 0 at 0 and 1 at 1.
///
/// @param light  0 to 1; below 0 and NaN give 0, above 1 the curve goes on
/// Textbook: 1.055 x^(1/2.4) - 0.055. Here 1 - 1.055 (1 - x^(1/2.4)): 1 keeps its byte.
/// Bound: 8 unit roundoffs of 1. Source: IEC 61966-2-1:1999, section 5.2.
template <class Real>
[[nodiscard]] Real encoded(const Real& light) {
  const auto constant = [](long double value) { return Real(static_cast<Scalar<Real>>(value)); };
  const Real least = constant(0.0031308L);
  const Real root = power(max(light, least), static_cast<Scalar<Real>>(1 / 2.4L));
  return select(light > least, Real(1) - constant(1.055L) * (Real(1) - root),
                max(light, Real(0)) * constant(12.92L));
}
/// The three channels of a color.
template <class Real>
[[nodiscard]] Color<Real> encoded(const Color<Real>& light) {
  return {encoded(light.r), encoded(light.g), encoded(light.b)};
}

}  // namespace texmap
