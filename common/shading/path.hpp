// Paths of light between matt surfaces and the sky.
#pragma once
#include <iterator>

#include "color.hpp"
#include "directions.hpp"
#include "nearest.hpp"

namespace texmap {

/// The light that arrives along a ray from a lone Lambertian sphere under a bright sky; see light_along.
///
/// Only what the scene requires: a sphere is convex, so that what leaves it meets nothing but the sky; under a constant sky it
/// does not matter where it goes, and no direction is drawn; and only rays that reach a changing sky need unit length.
template <class Real, class Object, class Sky, class Albedo, class Numbers>
[[nodiscard]] Color<Real> light_past_one(const Object& object, const Ray<Real>& ray, const Sky& sky, const Albedo& albedo,
                                         Numbers& numbers) {
  const Real distance = distance_to(object.sphere, ray);
  const Mask<Real> met = distance < infinity<Real>();
  const bool anywhere = sky.is_constant();
  Color<Real> light = gray(Real(0));
  if (any(!met)) light = sky(anywhere ? ray : Ray<Real>{ray.origin, normalize(ray.direction)});
  if (!any(met)) return light;

  const Hit<Real> hit = hit_at(object.sphere, ray, select(met, distance, Real(1)));
  const Ray<Real> next = anywhere ? ray : Ray<Real>{hit.outside, cosine_direction(hit.normal, numbers.pair())};
  return select(met, albedo(object, hit) * sky(next), light);
}

/// The light that arrives along a ray from a scene of Lambertian surfaces under a bright sky.
///
/// @param objects  none, one or more; where there are none the light is the sky's
/// @param ray      any length of direction
/// @param sky      called with a ray of unit length that leaves the scene, gives its light; says if it is_constant()
/// @param albedo   called with (object, hit), gives the share of light that the surface sends back, 0 to 1 in each channel
/// @param bounces  the most that a path may make, 1 or more; a path cut off there brings no light
/// @param numbers  its pair() gives two numbers in [0, 1), for each bounce new ones
/// @return  0 or more in each channel, at most the sky's brightest
/// One path is followed: at each surface it goes on in one direction, drawn in proportion to the cosine that Lambert's law
/// weighs it with, so that the weight and the chance cancel and only the albedo is left. The mean of many paths is the light.
/// Source: Kajiya, "The Rendering Equation" (1986); Lambertian scattering as in seeds 1 and 2.
template <class Real, class Objects, class Sky, class Albedo, class Numbers>
[[nodiscard]] Color<Real> light_along(const Objects& objects, Ray<Real> ray, const Sky& sky, const Albedo& albedo, int bounces,
                                      Numbers& numbers) {
  if (std::empty(objects)) return sky(sky.is_constant() ? ray : Ray<Real>{ray.origin, normalize(ray.direction)});
  if (std::size(objects) == 1) return light_past_one(*std::begin(objects), ray, sky, albedo, numbers);
  ray.direction = normalize(ray.direction);
  Color<Real> carried = gray(Real(1));
  Color<Real> light = gray(Real(0));
  Mask<Real> under_way = Real(0) < Real(1);
  for (int bounce = 0;; ++bounce) {
    const Nearest<Real> nearest = find_nearest(objects, ray);
    const Mask<Real> met = under_way && nearest.distance < infinity<Real>();
    light = select(under_way && !met, carried * sky(ray), light);
    under_way = met;
    if (bounce == bounces || !any(under_way)) return light;

    const Sample2<Real>& sample = numbers.pair();
    Ray<Real> next = ray;
    double index = 0;
    for (const auto& object : objects) {
      const Mask<Real> here = under_way && nearest.index == Real(index);
      index += 1;
      if (!any(here)) continue;
      const Hit<Real> hit = hit_at(object.sphere, ray, select(here, nearest.distance, Real(1)));
      carried = select(here, carried * albedo(object, hit), carried);
      next.origin = select(here, hit.outside, next.origin);
      next.direction = select(here, cosine_direction(hit.normal, sample), next.direction);
    }
    ray = next;
  }
}

}  // namespace texmap
