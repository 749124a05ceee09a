// The sRGB curve, between the bytes of a file and amounts of light.
#pragma once
#include "number/number.hpp"

namespace texmap {

/// The amount of light of an encoded channel.
///
/// @param encoded  a byte of a file divided by 255, 0 to 1; outside the curve goes on
/// @return         0 to 1, linear: twice the number is twice the light; NaN for NaN
/// Source: IEC 61966-2-1:1999, section 5.2.
template <class Real>
[[nodiscard]] Real srgb_decode(Real encoded) {
  if (encoded <= static_cast<Real>(0.04045L)) return encoded / static_cast<Real>(12.92L);
  return pow((encoded + static_cast<Real>(0.055L)) / static_cast<Real>(1.055L),
             static_cast<Real>(2.4L));
}

/// The encoded channel of an amount of light; the inverse of srgb_decode.
///
/// @param linear  0 to 1; outside the curve goes on
/// @return        0 to 1; times 255 and rounded it is the byte of a file; NaN for NaN
/// Every byte comes back.
/// Source: IEC 61966-2-1:1999, section 5.2.
template <class Real>
[[nodiscard]] Real srgb_encode(Real linear) {
  const auto constant = [](long double value) { return Real(static_cast<Scalar<Real>>(value)); };
  const Real least = constant(0.0031308L);
  const Real root = power(max(linear, least), 1 / static_cast<Scalar<Real>>(2.4L));
  return select(linear > least, constant(1.055L) * root - constant(0.055L),
                linear * constant(12.92L));
}

}  // namespace texmap
