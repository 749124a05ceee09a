// The point where a ray meets a surface.
#pragma once
#include "scene/ray.hpp"

namespace texmap {

/// Where a ray meets a surface.
template <class Real>
struct Hit {
  Vec3<Real> normal;   ///< outward, unit length; on an inner side towards the ray
  Vec3<Real> point;    ///< the hit point
  Vec3<Real> outside;  ///< the hit point lifted off the surface by a rounding bound
  Vec3<Real> inside;   ///< the hit point sunk below the surface by the same bound
  int object = -1;     ///< the index of what was hit, in the scene's list; -1 if it has none
};

/// The ray from a hit point in a direction of any length; it does not meet the surface there again.
/// Along the surface counts as outward. Domain: as hit_at.
template <class Real>
[[nodiscard]] Ray<Real> ray_from(const Hit<Real>& hit, const Vec3<Real>& direction) {
  return {select(dot(hit.normal, direction) < Real(0), hit.inside, hit.outside), direction};
}

}  // namespace texmap
