// The nearest object along a ray, and whether an object blocks it.
#pragma once
#include "scene/sphere.hpp"

namespace texmap {

/// The first object that a ray meets.
template <class Real>
struct Nearest {
  Real distance = infinity<Real>();  ///< +infinity for a miss
  Real index = Real(-1);             ///< in the list of objects; -1 for a miss
};

/// The first of `objects`, each with a `shape`, that the ray meets.
template <class Real, class Objects>
[[nodiscard]] Nearest<Real> find_nearest(const Objects& objects, const Ray<Real>& ray) {
  Nearest<Real> nearest;
  for (double index = 0; const auto& object : objects) {
    const Real distance = distance_to(object.shape, ray);
    const auto nearer = distance < nearest.distance;
    nearest.distance = select(nearer, distance, nearest.distance);
    nearest.index = select(nearer, Real(index++), nearest.index);
  }
  return nearest;
}

/// True where an object lies between the ray's origin and `distance` along it. The object with the
/// index `leaving`, from which the ray starts outward, is skipped if it is convex.
template <class Real, class Objects>
[[nodiscard]] Mask<Real> is_occluded(const Objects& objects, const Ray<Real>& ray,
                                     const Real& distance, int leaving = -1) {
  Real first = infinity<Real>();
  for (int index = 0; const auto& object : objects) {
    if (index++ != leaving || !object.shape.convex())
      first = min(distance_to(object.shape, ray), first);
  }
  return first < distance;
}

/// Calls `work` with (object, hit, mask) once for each object that some lane meets first; the mask
/// says which. In other lanes the hit has no meaning.
template <class Real, class Objects, class Work>
void for_each_hit(const Objects& objects, const Ray<Real>& ray, const Nearest<Real>& nearest,
                  const Work& work) {
  for (int index = -1; const auto& object : objects) {
    const Mask<Real> here = nearest.index == Real(++index);
    if (!any(here)) continue;
    Hit<Real> hit = hit_at(object.shape, ray, select(here, nearest.distance, Real(1)));
    hit.object = index;
    work(object, hit, here);
  }
}

/// The color along a ray: that of the first object it meets, or the background.
///
/// @param background  called with the ray if some lane meets nothing
/// @param shade       called with (object, hit) once for each object that some lane meets first
template <class Real, class Objects, class Background, class Shade>
[[nodiscard]] auto color_along(const Objects& objects, const Ray<Real>& ray,
                               const Background& background, const Shade& shade) {
  const Nearest<Real> nearest = find_nearest(objects, ray);
  decltype(background(ray)) color{};
  static_assert(std::is_same_v<decltype(shade(objects.front(), Hit<Real>{})), decltype(color)>,
                "an object's color must be a Color<Real>: of a Vec3 p it is {p.x, p.y, p.z}");
  if (any(nearest.index < Real(0))) color = background(ray);
  for_each_hit(objects, ray, nearest, [&](const auto& object, const auto& hit, const auto& here) {
    color = select(here, shade(object, hit), color);
  });
  return color;
}

}  // namespace texmap
