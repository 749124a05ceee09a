// A point light, and how much of it a surface receives.
#pragma once
#include "nearest.hpp"

namespace texmap {

/// A lamp too small to see, shining alike in all directions and at all distances.
struct PointLight {
  Point position;
};

/// A surface that looks alike from every side.
struct Matt {
  double ambient = 0.2;  ///< share of its color that is seen even in shadow, 0 to 1
  double diffuse = 0.8;  ///< share that the lamp adds where it shines straight down, 0 to 1
};

/// How the lamp stands over a hit point.
template <class Real>
struct Illumination {
  Vec3<Real> to_light;  ///< unit vector from the hit point to the lamp
  Real cosine;          ///< of the angle between `to_light` and the normal, or 0 where the lamp is hidden or behind the surface
};

/// The lamp as seen from a hit point, with the shadows of all objects.
///
/// Bound: `to_light` within 4 unit roundoffs, for a path whose square is in range; no point of seed 0's ground in its own
/// shadow, by any form of sphere; docs/numbers.md. No shadow ray is traced for a surface that faces away: there the answer is 0
/// anyway.
template <class Real, class Objects>
[[nodiscard]] Illumination<Real> illumination(const PointLight& light, const Objects& objects, const Hit<Real>& hit) {
  const Vec3<Real> path = number_cast<Real>(light.position) - hit.point;
  const Real distance = length(path);
  const Vec3<Real> to_light = path * (Real(1) / distance);
  const Real cosine = larger(dot(hit.normal, to_light), Real(0));
  if (!any(cosine > Real(0))) return {to_light, cosine};
  const Mask<Real> hidden = is_occluded(objects, Ray<Real>{hit.outside, to_light}, distance, hit.sphere);
  return {to_light, select(hidden, Real(0), cosine)};
}

/// The brightness of a matt surface, by Lambert's cosine law: ambient + diffuse cos.
///
/// @return  the factor on the surface's color, 0 to 1 when ambient + diffuse <= 1, within 2.5 unit roundoffs of itself
template <class Real>
[[nodiscard]] Real lambert(const Matt& matt, const Illumination<Real>& lamp) {
  return Real(matt.ambient) + Real(matt.diffuse) * lamp.cosine;
}

}  // namespace texmap
