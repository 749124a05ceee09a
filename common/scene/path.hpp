// Paths of light between Lambertian surfaces and the sky.
#pragma once
#include <iterator>

#include "math/color.hpp"
#include "sampling/directions.hpp"
#include "scene/nearest.hpp"

namespace texmap {

/// light_along for a scene of one convex object: all light at its surface comes from the sky.
/// Under a uniform sky no direction is drawn, since every direction brings the same light.
template <class Real, class Object, class Sky, class Random>
[[nodiscard]] Color<Real> light_past_one(const Object& object, const Ray<Real>& ray, const Sky& sky,
                                         Random& random) {
  const Real distance = distance_to(object.shape, ray);
  const Mask<Real> met = distance < infinity<Real>();
  const bool anywhere = sky.is_constant();
  Color<Real> light = gray(Real(0));
  if (any(!met)) light = sky(anywhere ? ray : Ray<Real>{ray.origin, normalize(ray.direction)});
  if (!any(met)) return light;

  const Hit<Real> hit = hit_at(object.shape, ray, select(met, distance, Real(1)));
  const Ray<Real> next =
      anywhere ? ray : Ray<Real>{hit.outside, cosine_direction(hit.normal, random.next_2d())};
  return select(met, object.paint(hit) * sky(next), light);
}

/// The light that arrives along a ray from Lambertian surfaces under a bright sky: one path,
/// continued at each surface in a cosine-weighted direction. The mean of many paths is the light.
///
/// @param objects, bounces  paints are albedos, 0 to 1; after `bounces` >= 1 a path brings no light
/// @param sky, random       called with a unit ray; next_2d() returns two numbers in [0, 1)
/// Source: Kajiya, "The Rendering Equation" (1986); One Weekend 2020, Next Week.
template <class Real, class Objects, class Sky, class Random>
[[nodiscard]] Color<Real> light_along(const Objects& objects, Ray<Real> ray, const Sky& sky,
                                      int bounces, Random& random) {
  if (std::empty(objects))
    return sky(sky.is_constant() ? ray : Ray<Real>{ray.origin, normalize(ray.direction)});
  if (std::size(objects) == 1 && std::begin(objects)->shape.convex())
    return light_past_one(*std::begin(objects), ray, sky, random);
  ray.direction = normalize(ray.direction);
  Color<Real> carried = gray(Real(1));
  Color<Real> light = gray(Real(0));
  Mask<Real> under_way = mask_of<Real>(true);
  for (int bounce = 0;; ++bounce) {
    Nearest<Real> nearest = find_nearest(objects, ray);
    nearest.index = select(under_way, nearest.index, Real(-1));
    const Mask<Real> met = nearest.index >= Real(0);
    light = select(under_way && !met, carried * sky(ray), light);
    under_way = met;
    if (bounce == bounces || !any(under_way)) return light;

    const Point2<Real>& sample = random.next_2d();
    Ray<Real> next = ray;
    const auto scatter = [&](const auto& object, const Hit<Real>& hit, const Mask<Real>& here) {
      carried = select(here, carried * object.paint(hit), carried);
      next.origin = select(here, hit.outside, next.origin);
      next.direction = select(here, cosine_direction(hit.normal, sample), next.direction);
    };
    for_each_hit(objects, ray, nearest, scatter);
    ray = next;
  }
}

}  // namespace texmap
