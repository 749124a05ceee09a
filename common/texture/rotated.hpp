// A mapping of a rotated point.
#pragma once
#include "math/rotation.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// A mapping after a rotation: the point is rotated, then mapped. The texture on the object turns
/// the other way.
template <class Mapping>
struct Rotated {
  RotationY rotation;
  Mapping mapping;

  /// The (u, v) that the mapping gives the rotated point.
  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const Vec3<Real>& p) const {
    return mapping(rotation(p));
  }
};

}  // namespace texmap
