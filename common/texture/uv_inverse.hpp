// From texture coordinates back to a direction.
#pragma once
#include "math/circle.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// The direction with these coordinates in the convention of Next Week; the inverse of uv_rtiow.
///
/// @param uv  any u, taken as it wraps around; v 0 to 1, from -y to +y
/// @return    of unit length; exactly -y and +y at v = 0 and 1
/// Bound: 4 unit roundoffs for u in 0 to 1; farther out the rounding of 1/2 - u adds to it.
template <class Real>
[[nodiscard]] Vec3<Real> direction_rtiow(const Uv<Real>& uv) {
  const OnCircle<Real> around = on_circle(Real(0.5) - uv.u);
  const OnCircle<Real> from_pole = on_circle(uv.v * Real(0.5));
  return {from_pole.sine * around.cosine, -from_pole.cosine, from_pole.sine * around.sine};
}

}  // namespace texmap
