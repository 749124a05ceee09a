// The ways in which the seeds lay (u, v) on a sphere, and how they are related.
#pragma once
#include "image_texture.hpp"
#include "uv.hpp"

namespace texmap {

/// Who says where on the sphere a texture begins and which way it runs. Seed 1's convention is seed 2's.
enum class Convention {
  daily,    ///< seed 0: u runs west from -x, v runs down from the north pole
  rtiow,    ///< seeds 1 and 2: u runs east from -x, v runs up from the south pole
  lecture,  ///< seed 4: u runs east from +z, v runs up from the south pole
};

/// Which way v runs over a picture in this convention: down in daily, up in the others. Errors: none.
[[nodiscard]] constexpr VAxis v_axis_of(Convention convention) {
  return convention == Convention::daily ? VAxis::down : VAxis::up;
}

/// Texture coordinates of a direction in any of the conventions.
///
/// @param p  any finite vector; only its direction matters
/// @return   u in [0, 1), v in [0, 1]
/// Errors: none. The zero vector gives (0.5, 0.5), in lecture (0.25, 0.5); vectors that are not finite have a place too.
/// Bound: that of uv_rtiow, 0.001 texel of 8192 by 4096 in float, 2e-12 in double; docs/numbers.md.
/// All are made from one formula by exact steps: u_daily = 1 - u, v_daily = 1 - v, u_lecture = frac(u - 1/4), with (u, v) in
/// the convention rtiow. Four formulas would be four times the roundings. Source: the seeds; the relations are proved in
/// docs/conventions.md.
template <class Real>
[[nodiscard]] Uv<Real> uv_of(Convention convention, const Vec3<Real>& p) {
  const Uv<Real> uv = uv_rtiow(p);
  switch (convention) {
    case Convention::daily:
      // 1 - 0 would be the seam's other name, 1, which is not in [0, 1).
      return {clamp_u(select(uv.u > Real(0), Real(1) - uv.u, Real(0))), Real(1) - uv.v};
    case Convention::lecture: {
      const Real u = uv.u - Real(0.25);
      return {clamp_u(select(u < Real(0), u + Real(1), u)), uv.v};
    }
    case Convention::rtiow:
      break;
  }
  return uv;
}

/// uv_of as a value, to be handed to a paint: domain, range and bound are those of uv_of.
struct ConventionMapping {
  Convention convention = Convention::rtiow;

  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const Vec3<Real>& p) const {
    return uv_of(convention, p);
  }
};

}  // namespace texmap
