// Where a ray meets a surface.
#pragma once
#include "ray.hpp"

namespace texmap {

/// Where a ray meets a surface.
template <class Real>
struct Hit {
  Vec3<Real> normal;             ///< outward, unit length; on a sphere, times the radius, the hit point as seen from the center
  Vec3<Real> point;              ///< the hit point in the world
  Vec3<Real> outside;            ///< the hit point lifted off the surface, so far that rounding cannot have left it inside
  Vec3<Real> inside;             ///< the hit point sunk below the surface, so far that rounding cannot have left it outside
  const void* sphere = nullptr;  ///< whose surface it is: a ray that leaves a sphere outward cannot meet it again
};

/// The ray that goes on from a hit point in some direction: it starts on the side of the surface that it goes to, and cannot
/// meet the surface again where it started.
///
/// @param hit        as `hit_at` gives it, in the domain stated there
/// @param direction  of any length, along the surface too; that counts as outward
/// @return           from `hit.outside` or `hit.inside`, in that direction
/// Errors: none; a direction that is zero or NaN gives a ray from outside that meets nothing.
/// Bound: no ray outward meets its own sphere, and every ray inward finds the far side, where the sphere's form is robust or
/// hybrid; the plain form keeps neither; docs/numbers.md. Source: as for `hit_at`.
template <class Real>
[[nodiscard]] Ray<Real> ray_from(const Hit<Real>& hit, const Vec3<Real>& direction) {
  return {select(dot(hit.normal, direction) < Real(0), hit.inside, hit.outside), direction};
}

}  // namespace texmap
