// A point light, and how much of it a surface receives.
#pragma once
#include "scene/nearest.hpp"

namespace texmap {

/// A point light, equally bright in all directions and at all distances.
struct PointLight {
  Point position;
};

/// A Lambertian material: equally bright from every side.
struct Lambertian {
  double ambient = 0.2;  ///< brightness in shadow, 0 to 1
  double diffuse = 0.8;  ///< what light that shines along the normal adds, 0 to 1
};

/// Where the light is, and how much of it arrives, at a hit point.
template <class Real>
struct LightSample {
  Vec3<Real> to_light;  ///< unit vector from the hit point to the light
  Real cosine;          ///< between `to_light` and the normal; 0 in shadow and on the far side
};

/// The LightSample of a hit point, with the shadows of all objects.
/// Domain: distances with squares in range.
template <class Real, class Objects>
[[nodiscard]] LightSample<Real> sample_light(const PointLight& light, const Objects& objects,
                                             const Hit<Real>& hit) {
  const Vec3<Real> path = number_cast<Real>(light.position) - hit.point;
  const Real distance = length(path);
  const Vec3<Real> to_light = path * (Real(1) / distance);
  const Real cosine = max(dot(hit.normal, to_light), Real(0));
  if (!any(cosine > Real(0))) return {to_light, cosine};
  const Mask<Real> hidden =
      is_occluded(objects, Ray<Real>{hit.outside, to_light}, distance, hit.object);
  return {to_light, select(hidden, Real(0), cosine)};
}

/// The brightness of a Lambertian surface, ambient + diffuse cos: a factor on its color.
template <class Real>
[[nodiscard]] Real lambert(const Lambertian& lambertian, const LightSample<Real>& light) {
  return Real(lambertian.ambient) + Real(lambertian.diffuse) * light.cosine;
}

}  // namespace texmap
