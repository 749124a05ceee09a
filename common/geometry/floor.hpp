// A horizontal plane and the point where a ray meets it.
#pragma once
#include "ray.hpp"

namespace texmap {

/// The plane y = height, without an end and seen from both sides.
struct Floor {
  double height = 0;
};

/// Distance along the ray to the floor, +infinity where it does not meet it ahead.
///
/// Distances are in lengths of `ray.direction`, which need not be a unit vector. A ray that starts on the floor does not meet
/// it, and neither does one along it. Only the ray's heights are looked at. Errors: none; heights that are NaN are a miss.
/// Bound: 2 ulp.
template <class Real>
[[nodiscard]] Real distance_to(const Floor& floor, const Ray<Real>& ray) {
  const Real distance = (Real(floor.height) - ray.origin.y) / ray.direction.y;
  return select(distance > Real(0), distance, infinity<Real>());
}

/// The point of the floor at a distance that `distance_to` gave.
///
/// Its height is that of the floor to the bit. Origin plus distance times direction has the height with a rounding error,
/// above the floor for one pixel and below it for the next: a texture in space that changes its color at that height, like
/// cubes of which some end at y = 0, then shows noise instead of a floor.
template <class Real>
[[nodiscard]] Vec3<Real> point_on(const Floor& floor, const Ray<Real>& ray, const Real& distance) {
  const Vec3<Real> along = ray.origin + ray.direction * distance;
  return {along.x, Real(floor.height), along.z};
}

}  // namespace texmap
