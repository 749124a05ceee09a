// Texture coordinates (u, v) of a direction: the map from a sphere to the unit square.
#pragma once
#include "vec3.hpp"

namespace texmap {

/// A place on a texture: u from its left to its right edge, v between bottom and top, both 0 to 1.
template <class Real>
struct Uv {
  Real u{}, v{};
};

/// Brings `u` into [0, 1): values that rounding lifted to 1 get the largest number below 1, a NaN gets 0.
///
/// @param u  anything the type can hold; it does not wrap: below 0 it becomes 0, from 1 on the largest number below 1
/// @return   `u` itself, to the bit, where it is in [0, 1)
/// Errors: none.
template <class Real>
[[nodiscard]] Real clamp_u(const Real& u) {
  return clamp(u, Real(0), below_one<Real>());
}

/// Texture coordinates of a direction, in the convention of "Ray Tracing: The Next Week".
///
/// @param p  any finite vector; only its direction matters
/// @return   u in [0, 1), 0 at -x and growing through +z, +x, -z; v in [0, 1], 0 at -y and 1 at +y
/// Errors: none. The zero vector gives (0.5, 0.5); at the poles, where every u is right, u is 0.5.
/// Bound: any length, any exponents: u (round the circle) and v within 0.001 texel of 8192 by 4096 in float, 2e-12 in double;
/// v within 4 ulp of itself at the lower pole, 5 in packs; docs/numbers.md.
/// v is the angle from -y as atan2(sine, cosine), not acos(-y): acos loses half the digits near the poles, where its slope is
/// infinite, and gives NaN when rounding made |y| larger than 1. Both sides are divided by the larger of |x| and |z|, so that
/// no length overflows or vanishes and `p` need not be a unit vector. Source: seed 2's convention; the form of the polar angle
/// as in Kahan, "How Futile are Mindless Assessments of Roundoff" (2006), on angles between vectors.
template <class Real>
[[nodiscard]] Uv<Real> uv_rtiow(const Vec3<Real>& p) {
  // Adding 0 turns -0 into +0, or the two ends of the seam would differ at z = -0.
  const Real x = p.x;
  const Real z = p.z + Real(0);
  const Real wide = larger(abs(x), abs(z));
  const Mask<Real> off_axis = wide > Real(0);

  const Real turn = atan2(select(off_axis, z, Real(0)), select(off_axis, x, Real(1)));
  const Real u = Real(0.5) - turn / (Real(2) * pi<Real>());

  const Real ratio = smaller(abs(x), abs(z)) / select(off_axis, wide, Real(1));
  const Real sine = select(off_axis, sqrt(Real(1) + square(ratio)), Real(0));
  const Real cosine = p.y / select(off_axis, wide, Real(1));
  const Mask<Real> zero = !off_axis && cosine == Real(0);
  const Real v = atan2(select(zero, Real(1), sine), -cosine) / pi<Real>();
  return {clamp_u(u), clamp(v, Real(0), Real(1))};
}

/// uv_rtiow as a value, to be handed to a paint.
struct RtiowMapping {
  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const Vec3<Real>& p) const {
    return uv_rtiow(p);
  }
};

}  // namespace texmap
