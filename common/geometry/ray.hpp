// A ray: where it starts and where it goes.
#pragma once
#include "vec3.hpp"

namespace texmap {

/// The points origin + t direction, t > 0. Distances along it are in lengths of `direction`.
template <class Real>
struct Ray {
  Vec3<Real> origin;
  Vec3<Real> direction;
};

}  // namespace texmap
