// Light as the channels of a picture.
#pragma once
#include "math/color.hpp"

namespace texmap {

/// A channel of light by the sRGB curve of image files: 0 for 0 and below, 1 for 1.
/// Bound: 8 unit roundoffs. Source: IEC 61966-2-1:1999, section 5.2.
template <class Real>
[[nodiscard]] Real encoded(const Real& light) {
  const Real least = Real(static_cast<Scalar<Real>>(0.0031308L));
  const Real slope = Real(static_cast<Scalar<Real>>(12.92L));
  const Real root = power(max(light, least), static_cast<Scalar<Real>>(1 / 2.4L));
  const Real factor = Real(static_cast<Scalar<Real>>(1.055L));
  const Real offset = Real(static_cast<Scalar<Real>>(0.055L));
  return select(light > least, factor * root - offset, max(light, Real(0)) * slope);
}
/// The three channels of a color.
template <class Real>
[[nodiscard]] Color<Real> encoded(const Color<Real>& light) {
  return {encoded(light.r), encoded(light.g), encoded(light.b)};
}

}  // namespace texmap
