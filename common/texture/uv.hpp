// Texture coordinates (u, v) of a direction: the map from a sphere to the unit square.
#pragma once
#include "math/vec3.hpp"

namespace texmap {

/// A place on a texture: u from left to right, v between bottom and top; the image covers 0 to 1.
template <class Real>
struct Uv {
  Real u{}, v{};
};

/// `u` limited to [0, 1), not wrapped: 1 and above give the largest number below 1, NaN gives 0.
template <class Real>
[[nodiscard]] Real clamp_u(const Real& u) {
  return clamp(u, Real(0), below_one<Real>());
}

/// Texture coordinates of a direction, in the convention of Next Week.
///
/// @param p  any finite vector of any length; zero gives (0.5, 0.5)
/// @return   u in [0, 1): 0 at -x, growing through +z; v in [0, 1] from -y to +y; u = 0.5 at poles
/// Textbook: u = atan2(-z, x) / (2 pi) + 1/2, v = acos(-y) / pi. Here v uses atan2, after Kahan.
template <class Real>
[[nodiscard]] Uv<Real> uv_rtiow(const Vec3<Real>& p) {
  // Adding 0 turns -0 into +0: otherwise u would jump at z = -0.
  const Real x = p.x;
  const Real z = p.z + Real(0);
  const Real wide = max(abs(x), abs(z));
  const Mask<Real> off_axis = wide > Real(0);

  const Real turn = atan2(select(off_axis, z, Real(0)), select(off_axis, x, Real(1)));
  const Real u = Real(0.5) - turn / (Real(2) * pi<Real>());

  // |z| first: where |x| = |z|, max takes one and min the other, as derivatives (chapter 09) need.
  const Real ratio = min(abs(z), abs(x)) / select(off_axis, wide, Real(1));
  const Real from_axis = select(off_axis, sqrt(Real(1) + square(ratio)), Real(0));
  const Real height = p.y / select(off_axis, wide, Real(1));
  const Mask<Real> zero = !off_axis && height == Real(0);
  const Real v = atan2(select(zero, Real(1), from_axis), -height) / pi<Real>();
  return {clamp_u(u), clamp(v, Real(0), Real(1))};
}

/// uv_rtiow as a mapping. To add a mapping, write a struct like this one.
struct RtiowMapping {
  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const Vec3<Real>& p) const {
    return uv_rtiow(p);
  }
};

}  // namespace texmap
