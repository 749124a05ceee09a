// A horizontal plane and the point where a ray meets it.
#pragma once
#include "scene/ray.hpp"

namespace texmap {

/// The infinite plane y = height, visible from both sides.
struct Floor {
  double height = 0;
};

/// Distance along the ray to the floor, in lengths of `ray.direction`; +infinity for a miss.
/// A ray that starts on the floor or runs along it misses it. Bound: 2 ulp
/// for the height as `Real` has it.
template <class Real>
[[nodiscard]] Real distance_to(const Floor& floor, const Ray<Real>& ray) {
  const Real distance = (Real(floor.height) - ray.origin.y) / ray.direction.y;
  return select(distance > Real(0), distance, infinity<Real>());
}

/// The point of the floor at a distance that `distance_to` returned; its height is exact.
/// Textbook: origin + distance direction; its height has a rounding error of either sign.
template <class Real>
[[nodiscard]] Vec3<Real> point_on(const Floor& floor, const Ray<Real>& ray, const Real& distance) {
  const Vec3<Real> along = ray.origin + ray.direction * distance;
  return {along.x, Real(floor.height), along.z};
}

/// The color of the floor where a ray meets it, else of the background.
///
/// @param background  called with the ray
/// @param paint       called with a point of the floor
template <class Real, class Background, class Paint>
[[nodiscard]] auto color_along(const Floor& floor, const Ray<Real>& ray,
                               const Background& background, const Paint& paint) {
  const Real distance = distance_to(floor, ray);
  const Mask<Real> met = distance < infinity<Real>();
  const Vec3<Real> point = point_on(floor, ray, select(met, distance, Real(1)));
  return select(met, paint(point), background(ray));
}

}  // namespace texmap
