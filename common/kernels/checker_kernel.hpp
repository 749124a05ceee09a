// The squares of a checkerboard on a globe, without an angle.
#pragma once
#include "color.hpp"
#include "vec3.hpp"

namespace texmap {

namespace checker_detail {

/// The complex number re + im i, or, where a weight w is given, re + im sqrt(w) i.
template <class Real>
struct Complex {
  Real re, im;
};

/// `base` to the power of `exponent`, 1 or more, by squarings; `weight` multiplies the square of i.
template <class Real>
[[nodiscard]] Complex<Real> power(const Complex<Real>& base, int exponent, const Real& weight) {
  int bit = 1;
  while (bit <= exponent / 2) bit *= 2;
  Complex<Real> result = base;
  for (bit /= 2; bit > 0; bit /= 2) {
    result = {result.re * result.re - weight * (result.im * result.im), Real(2) * (result.re * result.im)};
    if ((exponent & bit) != 0) {
      result = {result.re * base.re - weight * (result.im * base.im), result.re * base.im + result.im * base.re};
    }
  }
  return result;
}

/// True where the angle of `z`, counted from 0, lies in an even half turn; an edge belongs to the half turn that it begins.
template <class Real>
[[nodiscard]] Mask<Real> in_even_half_turn(const Complex<Real>& z) {
  return z.im > Real(0) || (z.im == Real(0) && z.re > Real(0));
}

}  // namespace checker_detail

/// True where floor(n u) + floor(n v) is even, for the (u, v) of a direction by uv_rtiow: without computing (u, v).
///
/// @param p        of a length from 1e-18 to 1e18 in float, 1e-150 to 1e150 in double
/// @param squares  n, even and from 2 to 64
/// The square of u changes where sin(pi n u) changes its sign. With m = n / 2 and the angle a = 2 pi u, whose cosine and sine
/// are as -x to z, that is sin(m a): by de Moivre the imaginary part of (-x + i z)^m. The square of v changes with the sign of
/// sin(n b), where b = pi v has a cosine and a sine as -y to s = sqrt(x^2 + z^2): the imaginary part of (-y + i s)^n =
/// ((y^2 - s^2) - 2 y s i)^m. There s only stands next to i, so that s^2 = x^2 + z^2 is all it takes: both signs are signs of
/// polynomials in x, y and z (Chebyshev's U of the second kind, times positive factors).
/// Exact, but for directions within 1/16 epsilon (in turns) of an edge in u or 1/8 epsilon (in half turns) of one in v: nearer
/// than the coordinates' own rounding. On the axes and on the seam it is right on the very edges. The band is the same for
/// every n: a power multiplies the angle and its error alike. In float, x and z may not both be under 1e-18 unless both are 0.
template <class Real>
[[nodiscard]] Mask<Real> is_even_square(const Vec3<Real>& p, int squares) {
  using namespace checker_detail;
  const int m = squares / 2;
  const Real wide = larger(abs(p.x), abs(p.z));
  const Mask<Real> off_axis = wide > Real(0);
  // On the axis u is 1/2. Beside it, a longer side of 1 keeps powers in range: 2^(m / 2) is the most that comes up.
  const Real divisor = select(off_axis, wide, Real(1));
  const Complex<Real> around = {select(off_axis, -p.x, Real(-1)) / divisor, p.z / divisor};
  const Mask<Real> column = in_even_half_turn(power(around, m, Real(1)));

  const Real axis_squared = p.x * p.x + p.z * p.z;
  const Real y_squared = p.y * p.y;
  const Real length_squared = y_squared + axis_squared;
  const Mask<Real> some = length_squared > Real(0);
  const Real scale = Real(1) / select(some, length_squared, Real(1));
  const Complex<Real> upright = {(y_squared - axis_squared) * scale, Real(-2) * p.y * scale};
  // v is 0 or 1 on the axis, and n is even: both poles are in an even row.
  const Mask<Real> row = in_even_half_turn(power(upright, m, axis_squared)) || !off_axis;
  return (column && row) || (!column && !row);
}

/// A checkerboard as a texture of directions: what Checkerboard paints through RtiowMapping, without an angle.
struct DirectionCheckerboard {
  Rgb even;  ///< the square at (0, 0)
  Rgb odd;
  int squares = 10;  ///< along u and along v: even, 2 to 64

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Vec3<Real>& direction) const {
    return select(is_even_square(direction, squares), number_cast<Real>(even), number_cast<Real>(odd));
  }
};

}  // namespace texmap
