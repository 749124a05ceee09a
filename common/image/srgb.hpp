// Between the numbers in a file and amounts of light: the sRGB curve.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace texmap {

/// The amount of light of an encoded channel.
///
/// @param encoded  0 to 1, a byte of a file divided by 255
/// @return         0 to 1, linear: twice the number is twice the light. Below 0 and above 1 the curve goes on; NaN gives NaN
/// Errors: none. Bound: 8 ulp for 1e-18 to 1; docs/numbers.md.
/// Source: IEC 61966-2-1:1999, section 5.2.
template <class Real>
[[nodiscard]] Real srgb_decode(Real encoded) {
  using std::pow;
  if (encoded <= static_cast<Real>(0.04045L)) return encoded / static_cast<Real>(12.92L);
  return pow((encoded + static_cast<Real>(0.055L)) / static_cast<Real>(1.055L), static_cast<Real>(2.4L));
}

/// The encoded channel of an amount of light; undoes srgb_decode.
///
/// @param linear  0 to 1, an amount of light
/// @return        0 to 1; times 255 and rounded it is the byte of a file. Below 0 and above 1 the curve goes on; NaN gives NaN
/// Errors: none. Bound: 5 ulp for 1e-18 to 1; every byte comes back from its light; docs/numbers.md.
/// Source: IEC 61966-2-1:1999, section 5.2. The two curves of the standard meet within 1e-7 of each other, not exactly.
template <class Real>
[[nodiscard]] Real srgb_encode(Real linear) {
  using std::pow;
  if (linear <= static_cast<Real>(0.0031308L)) return linear * static_cast<Real>(12.92L);
  return static_cast<Real>(1.055L) * pow(linear, 1 / static_cast<Real>(2.4L)) - static_cast<Real>(0.055L);
}

/// srgb_decode of every byte: place b holds the light, 0 to 1, of the byte b.
///
/// Errors: none. Computed once, at the first call: for tables that are asked for at each texel, light_of_bytes.
template <class Real>
[[nodiscard]] const std::array<Real, 256>& srgb_decode_table() {
  static const std::array<Real, 256> table = [] {
    std::array<Real, 256> light{};
    for (std::size_t byte = 0; byte < light.size(); ++byte) light[byte] = srgb_decode(static_cast<Real>(byte) / 255);
    return light;
  }();
  return table;
}

}  // namespace texmap
