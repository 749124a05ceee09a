// A ray: its origin and its direction.
#pragma once
#include "math/vec3.hpp"

namespace texmap {

/// The points origin + t direction, t > 0. Distances on it are in lengths of `direction`.
template <class Real>
struct Ray {
  Vec3<Real> origin;
  Vec3<Real> direction;
};

}  // namespace texmap
