// Pictures of surfaces instead of their light: normals, (u, v), objects. They help to find errors.
#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "engine/render/settings.hpp"
#include "scene/floor.hpp"
#include "scene/mesh.hpp"
#include "scene/nearest.hpp"
#include "scene/paint.hpp"
#include "texture/uv.hpp"

namespace texmap {

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

/// Lessons with a list of objects, each with a `shape` and a `paint`.
template <class Lesson>
concept HasObjects = requires(const Lesson& lesson) {
  lesson.objects.front().shape;
  lesson.objects.front().paint;
};
/// The surface of a mesh at a hit.
template <class Real, class Paint>
[[nodiscard]] Surface<Real> surface_at(const MeshHit<Real>& hit, const Paint& paint) {
  if (!hit.met) return {};
  return {static_cast<int>(hit.triangle), hit.normal, uv_of_paint(paint, hit)};
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

/// The surface that a lesson's ray meets first. A lesson with more than objects has an overload in
/// its chapter's surface.hpp, which its main.cpp includes.
template <class Real, HasObjects Lesson>
[[nodiscard]] Surface<Real> surface_along(const Lesson& lesson, const Ray<Real>& ray) {
  return surface_of(lesson.objects, ray);
}

/// Lessons with surfaces that --show can draw.
template <class Lesson>
concept HasSurfaces = requires(const Lesson& lesson, const Ray<double>& ray) {
  surface_along(lesson, ray);
};

/// The colors of objects, in their order; after the last the first comes again.
inline constexpr std::array<Rgb, 16> object_colors = {{{0.9, 0.1, 0.1},
                                                       {0.1, 0.7, 0.2},
                                                       {0.15, 0.35, 0.95},
                                                       {1, 0.85, 0.1},
                                                       {0.6, 0.2, 0.8},
                                                       {0.1, 0.85, 0.85},
                                                       {0.95, 0.5, 0.1},
                                                       {0.95, 0.55, 0.8},
                                                       {0.5, 0.3, 0.1},
                                                       {0.65, 0.85, 0.3},
                                                       {0.05, 0.4, 0.4},
                                                       {0.75, 0.75, 0.75},
                                                       {0.55, 0, 0.2},
                                                       {1, 0.8, 0.6},
                                                       {0.1, 0.1, 0.5},
                                                       {0.4, 0.4, 0.45}}};

/// A surface as a color; the sky is black. Coordinates beyond 0 to 1 show their fractional part.
template <class Real>
[[nodiscard]] Color<Real> color_of_surface(const Surface<Real>& surface, Shown shown) {
  if (surface.object < 0) return gray(Real(0));
  const auto on_picture = [](const Real& x) {
    return x >= Real(0) && x <= Real(1) ? x : x - floor(x);
  };
  switch (shown) {
    case Shown::normal: {
      const Vec3<Real> half = (surface.normal + Vec3<Real>{Real(1), Real(1), Real(1)}) * Real(0.5);
      return {half.x, half.y, half.z};
    }
    case Shown::uv:
      if (!surface.has_uv()) return gray(Real(0.5));
      return {on_picture(surface.uv.u), on_picture(surface.uv.v), Real(0)};
    case Shown::object:
      return number_cast<Real>(
          object_colors[static_cast<std::size_t>(surface.object) % object_colors.size()]);
    case Shown::color:
      break;
  }
  return gray(Real(0));
}

/// The surfaces of a lesson as something that can be rendered, with single numbers.
template <class Lesson>
struct SurfaceColors {
  const Lesson& lesson;
  Shown shown;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    return color_of_surface(surface_along(lesson, ray), shown);
  }
};

}  // namespace texmap
