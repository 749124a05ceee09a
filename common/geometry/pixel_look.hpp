// What one look through the middle of a pixel tells of the whole pixel.
#pragma once
#include "camera.hpp"
#include "sphere.hpp"

namespace texmap {

/// How far what a pixel sees may be smoothed, as a PixelLook measures it. Zeros: not at all.
struct Smoothing {
  double most_bend = 0;  ///< where places are taken from a polynomial of the second degree
  double most_tilt = 0;  ///< where directions are taken from one of the first

  // What places and directions are then off by; held in tests/shading/test_pixel_patch.cpp.
  static constexpr double turns_per_bend = 0.03;       ///< in longitude
  static constexpr double half_turns_per_bend = 0.05;  ///< in latitude
  static constexpr double normal_per_tilt = 0.9;       ///< in each coordinate of a normal of unit length
  static constexpr double direction_per_tilt = 1.4;    ///< in each coordinate of what cosine_direction makes of it
};

/// A look at a sphere, or beside it.
template <class Real>
struct PixelLook {
  Mask<Real> beside;  ///< no ray through the pixel meets the sphere
  Real bend;          ///< how much places on the sphere differ from those of a flat picture: 0 or more, or +infinity where some
                      ///< ray may miss it, come from inside of it, or meet it close to a pole of the mapping
  Real tilt;          ///< how much normals differ from those of an evenly bent surface, likewise
};

/// Looks at a sphere through the middles of pixels.
///
/// Let h be half of a pixel's width at the point of the line of sight that is nearest to the center, c the cosine of the angle
/// between the line and the normal, and a the normal's distance from the axis, all in radii. The limb is about c^2 / 2 away,
/// the pole at least a c. Derivatives of latitude and longitude grow toward both, the third ones with h by
///     bend = ((h / c^2)^3 + (h / (a c))^3) c / max(a, c),
/// those of the normal toward the limb alone, the second ones by
///     tilt = h^2 / c^3.
/// Domain: a sphere whose axis is y; views of any kind. Source: the form from the derivatives of asin and atan2; the factors of
/// Smoothing are measured.
template <class Real>
[[nodiscard]] PixelLook<Real> look_through(const ViewIn<Real>& view, const SphereIn<Real>& sphere, const Real& column,
                                           const Real& row) {
  const Ray<Real> ray{view.eye, direction_through(view, column, row)};
  const Vec3<Real> to_center = sphere.center - ray.origin;
  const Vec3<Real> moment = cross(to_center, ray.direction);
  const Real squared = dot(ray.direction, ray.direction);
  const Real to_foot = dot(to_center, ray.direction) / squared;
  const Real width = view.pixel * to_foot;
  const Real reach = sphere.radius + width;  // half of a diagonal is 0.71 widths
  const Mask<Real> beside = to_foot > Real(0) && dot(moment, moment) > squared * square(reach);

  const Real distance = distance_to(sphere, ray);
  const Mask<Real> met = distance < infinity<Real>();
  if (!any(met)) return {beside, infinity<Real>(), infinity<Real>()};
  const Vec3<Real> normal = normal_at(sphere, ray, select(met, distance, Real(1)));
  const Real h = Real(0.5) * width * sphere.inverse_radius;
  const Real c = -dot(normal, ray.direction) / sqrt(squared);
  const Real a = sqrt(square(normal.x) + square(normal.z));
  const Real to_limb = h / square(c);
  const Real to_pole = h / (a * c);
  const Mask<Real> known = met && c > Real(0) && to_limb + to_pole < Real(0.1);
  const Real cubes = square(to_limb) * to_limb + square(to_pole) * to_pole;
  return {beside, select(known, cubes * c / larger(a, c), infinity<Real>()),
          select(known, square(to_limb) * c, infinity<Real>())};
}

}  // namespace texmap
