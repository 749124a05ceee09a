// A color as amounts of red, green and blue light.
#pragma once
#include "number/number.hpp"

namespace texmap {

/// Red, green and blue light, 0 to 1; above 1 a color is brighter than a pixel can show.
template <class Real>
struct Color {
  Real r{}, g{}, b{};

  /// `yes` where the mask is true, else `no`.
  [[nodiscard]] friend Color select(const Mask<Real>& mask, const Color& yes, const Color& no) {
    return {select(mask, yes.r, no.r), select(mask, yes.g, no.g), select(mask, yes.b, no.b)};
  }
};

/// A color of a scene. Scenes are written in double.
using Rgb = Color<double>;

/// The color in another number, such as the one that a picture is drawn with.
template <class Real, class Other>
[[nodiscard]] Color<Real> number_cast(const Color<Other>& c) {
  return {Real(c.r), Real(c.g), Real(c.b)};
}

/// The light of two sources together. Bound, here and below: one rounding a channel.
template <class Real>
[[nodiscard]] Color<Real> operator+(const Color<Real>& a, const Color<Real>& b) {
  return {a.r + b.r, a.g + b.g, a.b + b.b};
}
/// Light `b` reflected by a surface of color `a`: channel by channel.
template <class Real>
[[nodiscard]] Color<Real> operator*(const Color<Real>& a, const Color<Real>& b) {
  return {a.r * b.r, a.g * b.g, a.b * b.b};
}
/// Light `a`, `s` times as bright.
template <class Real>
[[nodiscard]] Color<Real> operator*(const Color<Real>& a, const Real& s) {
  return {a.r * s, a.g * s, a.b * s};
}

/// Light with three equal channels.
template <class Real>
[[nodiscard]] Color<Real> gray(const Real& brightness) {
  return {brightness, brightness, brightness};
}

/// Linear interpolation: `a` at t = 0, `b` at t = 1, both to the bit.
/// Textbook: a (1 - t) + b t. Here the step t (b - a) starts from the nearer end.
/// Domain: t in [0, 1]; numbers and channels below half of the largest number.
template <class Real>
[[nodiscard]] Real mix(const Real& a, const Real& b, const Real& t) {
  return select(t < Real(0.5), a + t * (b - a), b - (Real(1) - t) * (b - a));
}
template <class Real>
[[nodiscard]] Color<Real> mix(const Color<Real>& a, const Color<Real>& b, const Real& t) {
  return {mix(a.r, b.r, t), mix(a.g, b.g, t), mix(a.b, b.b, t)};
}

}  // namespace texmap
