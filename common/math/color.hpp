// A color as red, green and blue light, 1 being the brightest a pixel can show.
#pragma once
#include "number.hpp"

namespace texmap {

/// Red, green and blue, 0 dark to 1 bright. Values above 1 are allowed until a pixel clamps them.
template <class Real>
struct Color {
  Real r{}, g{}, b{};

  /// `yes` where the mask is true, else `no`.
  [[nodiscard]] friend Color select(const Mask<Real>& mask, const Color& yes, const Color& no) {
    return {select(mask, yes.r, no.r), select(mask, yes.g, no.g), select(mask, yes.b, no.b)};
  }
};

/// A color of a scene, written in double like every scene.
using Rgb = Color<double>;

/// The color in the number a picture is drawn with, each channel rounded once. Errors: none.
template <class Real>
[[nodiscard]] Color<Real> number_cast(const Rgb& c) {
  return {Real(c.r), Real(c.g), Real(c.b)};
}

/// The light of two sources together.
///
/// Domain: any channels. Bound of this and of both products: each channel is rounded once, so that it is within 1 unit roundoff
/// of itself as long as it stays in the range of normal numbers. Errors: none; beyond the range it is infinite.
template <class Real>
[[nodiscard]] Color<Real> operator+(const Color<Real>& a, const Color<Real>& b) {
  return {a.r + b.r, a.g + b.g, a.b + b.b};
}
/// Light `b` falling on a surface of color `a`: channel by channel.
template <class Real>
[[nodiscard]] Color<Real> operator*(const Color<Real>& a, const Color<Real>& b) {
  return {a.r * b.r, a.g * b.g, a.b * b.b};
}
/// Light `a`, `s` times as bright.
template <class Real>
[[nodiscard]] Color<Real> operator*(const Color<Real>& a, const Real& s) {
  return {a.r * s, a.g * s, a.b * s};
}

/// Light without a hue: three equal channels. Errors: none.
template <class Real>
[[nodiscard]] Color<Real> gray(const Real& brightness) {
  return {brightness, brightness, brightness};
}

/// `a` at t = 0, `b` at t = 1, and on the straight line between them in between.
///
/// @param t  weight of `b`, 0 to 1, one for all channels
/// Domain: channels below half of the largest number. Bound: 2 unit roundoffs of the larger end; docs/numbers.md.
/// Both ends are met to the bit, and a color mixed with itself stays itself to the bit: the step of t (b - a) is taken from the
/// nearer end. Errors: none; outside its domain t carries the line on beyond the ends. The usual a (1 - t) + b t changes a byte
/// mixed with itself for 41 of 256 bytes at t = 0.3.
template <class Real>
[[nodiscard]] Color<Real> mix(const Color<Real>& a, const Color<Real>& b, const Real& t) {
  const Color<Real> from_a = {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b)};
  const Real rest = Real(1) - t;
  const Color<Real> from_b = {b.r - rest * (b.r - a.r), b.g - rest * (b.g - a.g), b.b - rest * (b.b - a.b)};
  return select(t < Real(0.5), from_a, from_b);
}

}  // namespace texmap
