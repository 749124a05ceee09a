// A hit as a function of two small steps along the surface.
#pragma once
#include "number/dual.hpp"
#include "sampling/directions.hpp"
#include "scene/hit.hpp"

namespace texmap {

/// The hit with derivatives by a step along `frame.right` (x) and one along `frame.up` (y), both in
/// units of the scene. Mappings and paints called with it give their slopes along the surface.
///
/// @param frame      unit vectors along the surface, as frame_about(hit.normal) gives them
/// @param curvature  how fast the normal turns: 1 / radius on a sphere, 0 on a plane
template <class Real>
[[nodiscard]] Hit<Dual<Real>> with_steps(const Hit<Real>& hit, const Frame<Real>& frame,
                                         const Real& curvature) {
  const auto moving = [&](const Vec3<Real>& p, const Real& speed) {
    const Vec3<Real> right = frame.right * speed;
    const Vec3<Real> up = frame.up * speed;
    return Vec3<Dual<Real>>{{p.x, right.x, up.x}, {p.y, right.y, up.y}, {p.z, right.z, up.z}};
  };
  return {moving(hit.normal, curvature), moving(hit.point, Real(1)), moving(hit.outside, Real(1)),
          hit.object};
}

/// The hit after a straight step, its normal turned as on a sphere. Bound: right to first order.
template <class Real>
[[nodiscard]] Hit<Real> moved(const Hit<Real>& hit, const Vec3<Real>& step, const Real& curvature) {
  return {normalize(hit.normal + step * curvature), hit.point + step, hit.outside + step,
          hit.object};
}

}  // namespace texmap
