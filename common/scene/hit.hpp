// The point where a ray meets a surface.
#pragma once
#include "scene/ray.hpp"

namespace texmap {

/// Where a ray meets a surface.
template <class Real>
struct Hit {
  Vec3<Real> normal;   ///< outward, unit length; on an inner side towards the ray, but in a sphere
  Vec3<Real> point;    ///< the hit point
  Vec3<Real> outside;  ///< the hit point lifted off the surface by a rounding bound
  int object = -1;     ///< the index of what was hit, in the scene's list; -1 if it has none
};

}  // namespace texmap
