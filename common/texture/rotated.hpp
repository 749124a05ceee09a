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

  /// @param p  any vector of the mapping's domain; its length stays the same but for rounding
  /// @return   what the mapping gives: with RtiowMapping, u in [0, 1) and v in [0, 1]
  /// Bound: with RtiowMapping, u moves by degrees / 360 within 0.001 texel of 8192 by 4096 in float, 2e-12 in double, for any
  /// angle to 1e300 degrees; docs/numbers.md. Errors: those of the mapping.
  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const Vec3<Real>& p) const {
    return mapping(rotation(p));
  }
};

}  // namespace texmap
