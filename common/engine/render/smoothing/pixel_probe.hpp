// Probes the center of a pixel to learn how smooth the pixel is.
#pragma once
#include "engine/kernels/prepared_scene.hpp"
#include "engine/kernels/smoothing.hpp"

namespace texmap {

/// What a probe of a pixel tells about a sphere.
template <class Real>
struct PixelProbe {
  Mask<Real> misses;     ///< every ray through the pixel misses the sphere
  Real curvature_error;  ///< third-order error of places; +infinity at the limb and the poles
  Real normal_error;     ///< second-order error of normals; the same
};

/// Probes a sphere with axis y through the centers of pixels. With half a pixel's width h at the
/// sphere, the cosine c of the angle between ray and normal, and the normal's distance a from the
/// axis, all in radii:
///     curvature_error = ((h / c^2)^3 + (h / (a c))^3) c / max(a, c),  normal_error = h^2 / c^3.
/// Source: derivatives of asin and atan2; the factors in Smoothing are measured.
template <class Real>
[[nodiscard]] PixelProbe<Real> probe_pixel(const View<Real>& view,
                                           const PreparedSphere<Real>& sphere, const Real& column,
                                           const Real& row) {
  const Ray<Real> ray{view.eye, direction_through(view, column, row)};
  const Vec3<Real> to_center = sphere.center - ray.origin;
  const Vec3<Real> moment = cross(to_center, ray.direction);
  const Real squared = dot(ray.direction, ray.direction);
  const Real to_foot = dot(to_center, ray.direction) / squared;
  const Real width = view.pixel * to_foot;
  const Real reach = sphere.radius + width;  // half a pixel's diagonal is 0.71 widths
  const Mask<Real> misses = to_foot > Real(0) && dot(moment, moment) > squared * square(reach);
  if (!any(!misses)) return {misses, infinity<Real>(), infinity<Real>()};

  const Real distance = distance_to(sphere, ray);
  const Mask<Real> met = distance < infinity<Real>();
  if (!any(met)) return {misses, infinity<Real>(), infinity<Real>()};
  const Vec3<Real> normal = normal_at(sphere, ray, select(met, distance, Real(1)));
  const Real h = Real(0.5) * width * sphere.inverse;
  const Real c = -dot(normal, ray.direction) / sqrt(squared);
  const Real a = sqrt(square(normal.x) + square(normal.z));
  const Real to_limb = h / square(c);
  const Real to_pole = h / (a * c);
  const Mask<Real> known = met && c > Real(0) && to_limb + to_pole < Real(0.1);
  const Real cubes = square(to_limb) * to_limb + square(to_pole) * to_pole;
  return {misses, select(known, cubes * c / max(a, c), infinity<Real>()),
          select(known, square(to_limb) * c, infinity<Real>())};
}

}  // namespace texmap
