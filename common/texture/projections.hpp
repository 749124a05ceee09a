// Maps from the sphere to a flat picture, and back.
#pragma once
#include "texture/cube_map.hpp"
#include "texture/octahedral_map.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap {

/// How a picture of the whole sphere is laid out. All read as printed, seen from outside.
/// To add one, name it here: the compiler asks for the rest, but for its row in
/// projection_facts.hpp. `project` also runs on `Dual` and on intervals, which have no sin and cos:
/// take on_circle. Chapter 10's sheet has no place for an eighth: see its static_assert.
enum class Projection {
  equirect,      ///< longitude and latitude: uv_rtiow
  plane,         ///< along the axis onto a plane, seen from +y: the upper half of the sphere alone
  cylinder,      ///< straight out onto a cylinder around it: Lambert, equal areas
  cube,          ///< from the middle onto the six faces of a cube
  equi_angular,  ///< the same with equal angles between texels
  octahedral,    ///< onto an octahedron, its lower half folded out
  equal_area,    ///< the same with equal areas
};

/// The cylinder's map of a point: the angle around the y axis, and the height from -1 to 1.
/// On the cylinder of radius 1 itself no length changes: u is an arc / (2 pi), v a height / 2.
template <class Real>
[[nodiscard]] Uv<Real> uv_cylinder(const Vec3<Real>& p) {
  const Mask<Real> off_axis = max(abs(p.x), abs(p.z)) > Real(0);
  const Real turn = atan2(select(off_axis, p.z + Real(0), Real(0)),
                          select(off_axis, p.x, Real(1)));  // adding 0 turns -0 into +0
  return {clamp_u(Real(0.5) - turn / (Real(2) * pi<Real>())),
          clamp(Real(0.5) + Real(0.5) * p.y, Real(0), Real(1))};
}

/// Texture coordinates of a direction.
///
/// @param p  any vector of a length from 1e-15 to 1e15; only its direction matters
/// @return   u in [0, 1), v in [0, 1] upwards; `plane` gives p and its image below the same place
/// Bound: 0.001 texel of 4096 in float, 2e-12 in double, poles included.
template <class Real>
[[nodiscard]] Uv<Real> project(Projection projection, const Vec3<Real>& p) {
  switch (projection) {
    case Projection::plane: {
      const Vec3<Real> n = normalize(p);
      return uv_from_square(n.x, -n.z);
    }
    case Projection::cylinder:
      return uv_cylinder(normalize(p));
    case Projection::cube:
      return uv_cube(CubeSpacing::even, p);
    case Projection::equi_angular:
      return uv_cube(CubeSpacing::equi_angular, p);
    case Projection::octahedral:
      return uv_octahedral(p);
    case Projection::equal_area:
      return uv_equal_area(p);
    case Projection::equirect:
      break;
  }
  return uv_rtiow(p);
}

/// The direction with these coordinates, of unit length: the inverse of project.
///
/// @param uv  0 to 1; for `plane` inside the disk, outside it the nearest direction of its rim
/// Bound: 8 unit roundoffs; near the rim of `plane` their square root.
template <class Real>
[[nodiscard]] Vec3<Real> unproject(Projection projection, const Uv<Real>& uv) {
  switch (projection) {
    case Projection::plane: {
      const Real x = Real(2) * uv.u - Real(1);
      const Real z = Real(1) - Real(2) * uv.v;
      const Real height = Real(1) - square(x) - square(z);
      return normalize(Vec3<Real>{x, sqrt(max(height, Real(0))), z});
    }
    case Projection::cylinder: {
      const OnCircle<Real> around = on_circle(Real(0.5) - uv.u);
      const Real radius = Real(2) * sqrt(uv.v * (Real(1) - uv.v));  // sqrt(1 - y^2)
      return {radius * around.cosine, Real(2) * uv.v - Real(1), radius * around.sine};
    }
    case Projection::cube:
      return direction_cube(CubeSpacing::even, uv);
    case Projection::equi_angular:
      return direction_cube(CubeSpacing::equi_angular, uv);
    case Projection::octahedral:
      return direction_octahedral(uv);
    case Projection::equal_area:
      return direction_equal_area(uv);
    case Projection::equirect:
      break;
  }
  return direction_rtiow(uv);
}

/// A projection as a mapping.
struct ProjectionMapping {
  Projection projection = Projection::equirect;

  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const Vec3<Real>& p) const {
    return project(projection, p);
  }
};

}  // namespace texmap
