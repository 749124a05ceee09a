// A mapping that turns with its object.
#pragma once
#include "rotation.hpp"
#include "uv.hpp"

namespace texmap {

/// A mapping behind a rotation: the point turns first, then it is mapped.
template <class Mapping>
struct Rotated {
  RotationY rotation;
  Mapping mapping;

  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const Vec3<Real>& p) const {
    return mapping(rotation(p));
  }
};

}  // namespace texmap
