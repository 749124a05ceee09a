// The equal-area octahedral map as it is usually written.
#pragma once
#include "texture/octahedral_map.hpp"

namespace texmap::published {

/// The place on the equal-area octahedral map of a direction with y >= 0, of unit length.
/// Fails near the pole: 1 - y cancels. For n rounded to float up to 0.35 texel of 4096 is lost.
/// Source: Clarberg (2008); the same form is in pbrt-v4's EqualAreaSphereToSquare.
template <class Real>
[[nodiscard]] Uv<Real> uv_equal_area(const Vec3<Real>& n) {
  const Real distance = sqrt(Real(1) - n.y);
  const Real quarter = atan2(abs(n.z), abs(n.x)) * (Real(2) / pi<Real>());
  const Real along_z = quarter * distance;
  return uv_from_square(with_sign_of(n.x, distance - along_z), with_sign_of(-n.z, along_z));
}

}  // namespace texmap::published
