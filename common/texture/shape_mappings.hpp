// Where a picture lies on a cylinder and on a rectangle.
#pragma once
#include "scene/shapes.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// A label once round a cylinder: u runs with the angle as on the globe (0 at -x, 1/4 at +z), v
/// from its lower end to its upper end. Both grow evenly along the surface.
/// Bound: that of uv_rtiow.
struct CylinderMapping {
  Cylinder cylinder;

  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const Hit<Real>& hit) const {
    const Vec3<Real> p = hit.point - number_cast<Real>(cylinder.center);
    const Real height = p.y / Real(cylinder.half_height);
    return {uv_rtiow(Vec3<Real>{p.x, Real(0), p.z}).u,
            clamp(Real(0.5) + Real(0.5) * height, Real(0), Real(1))};
  }
};

/// The whole picture on a rectangle: (0, 0) at the left end of its lower side, seen from where
/// right, up and towards the eye make a right-handed system.
struct RectangleMapping {
  Rectangle rectangle;

  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const Hit<Real>& hit) const {
    const Vec3<Real> p = hit.point - number_cast<Real>(rectangle.center);
    const auto part = [&p](const Vec3d& side) {
      const Vec3<Real> along = number_cast<Real>(side);
      const Real of_side = dot(p, along) / dot(along, along);
      return clamp(Real(0.5) + Real(0.5) * of_side, Real(0), Real(1));
    };
    return {clamp_u(part(rectangle.right)), part(rectangle.up)};
  }
};

}  // namespace texmap
