// What a ray meets: object, normal and (u, v).
#pragma once
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "scene/nearest.hpp"
#include "scene/paint.hpp"
#include "texture/uv.hpp"

namespace texmap {

struct Floor;
template <class Real>
struct MeshHit;

/// The surface that a ray meets first.
template <class Real>
struct Surface {
  int object = -1;    ///< its number in the scene, -1 for the sky; a mesh has one for each triangle
  Vec3<Real> normal;  ///< unit length, with the lesson's bumps
  Uv<Real> uv{std::numeric_limits<Real>::quiet_NaN(), Real(0)};  ///< u is NaN if there is none

  [[nodiscard]] bool has_uv() const { return !std::isnan(uv.u); }
};

/// The (u, v) with which a paint is looked up at a hit; of a paint without them, u is NaN.
template <template <class> class AnyHit, class Real, class Paint>
[[nodiscard]] Uv<Real> uv_of_paint(const Paint& paint, const AnyHit<Real>& hit) {
  if constexpr (requires { paint.mapping(hit); }) {
    return paint.mapping(hit);
  } else if constexpr (requires { paint.mapping(hit.normal); }) {
    return paint.mapping(hit.normal);
  } else {
    return Surface<Real>{}.uv;
  }
}
template <template <class> class AnyHit, class Real, class... Paints>
[[nodiscard]] Uv<Real> uv_of_paint(const AnyOf<Paints...>& paint, const AnyHit<Real>& hit) {
  return std::visit([&hit](const auto& one) { return uv_of_paint(one, hit); },
                    static_cast<const std::variant<Paints...>&>(paint));
}

/// The surface of a mesh at a hit.
///
/// @param normal_of  called with the hit
template <class Real, class Paint, class NormalOf>
[[nodiscard]] Surface<Real> surface_at(const MeshHit<Real>& hit, const Paint& paint,
                                       const NormalOf& normal_of) {
  if (!hit.met) return {};
  return {static_cast<int>(hit.triangle), normal_of(hit), uv_of_paint(paint, hit)};
}

/// The surface of the object that a ray meets first.
///
/// @param normal_of  called with the object and its hit
template <class Real, class Object, class NormalOf>
[[nodiscard]] Surface<Real> surface_of(const std::vector<Object>& objects, const Ray<Real>& ray,
                                       const NormalOf& normal_of) {
  const Nearest<Real> nearest = find_nearest(objects, ray);
  if (!(nearest.index >= Real(0))) return {};
  const Object& object = objects[static_cast<std::size_t>(nearest.index)];
  const Hit<Real> hit = hit_at(object.shape, ray, nearest.distance);
  return {static_cast<int>(nearest.index), normal_of(object, hit), uv_of_paint(object.paint, hit)};
}
template <class Real, class Object>
[[nodiscard]] Surface<Real> surface_of(const std::vector<Object>& objects, const Ray<Real>& ray) {
  return surface_of(objects, ray, [](const Object&, const Hit<Real>& hit) { return hit.normal; });
}

/// The surface of the floor along a ray, as the object with this number.
template <class Real, class Mapping>
[[nodiscard]] Surface<Real> surface_of(const Floor& floor, const Mapping& mapping, int number,
                                       const Ray<Real>& ray) {
  const Real distance = distance_to(floor, ray);
  if (!(distance < infinity<Real>())) return {};
  return {number, {Real(0), Real(1), Real(0)}, mapping(point_on(floor, ray, distance))};
}

}  // namespace texmap
