// Refuses shapes of a lesson's own that would be drawn wrong in silence.
#pragma once
#include <stdexcept>
#include <string>

#include "sampling/directions.hpp"
#include "scene/camera.hpp"
#include "scene/nearest.hpp"
#include "scene/shapes.hpp"
#include "texture/mapped.hpp"

namespace texmap {

/// 2 for a sphere, 1 for what is derived from one and has its normals, 0 for other shapes.
template <class Shape>
[[nodiscard]] int roundness(const Shape&) {
  return SphereLike<Shape> ? 2 : requires(const Shape& shape) { shape.form; }
  ? 1 : 0;
}
template <class... Shapes>
[[nodiscard]] int roundness(const AnyShape<Shapes...>& any) {
  return any.with([](const auto& one) { return roundness(one); });
}

/// True for a paint that takes the normal for the direction of the point.
template <class Paint>
[[nodiscard]] bool takes_normal(const Paint&) {
  return requires(const Paint& paint) { paint.mapping; }
  &&!requires(const Paint& paint, const Hit<double>& hit) { paint.mapping(hit); };
}
template <class... Paints>
[[nodiscard]] bool takes_normal(const AnyOf<Paints...>& any) {
  return std::visit([](const auto& paint) { return takes_normal(paint); },
                    static_cast<const std::variant<Paints...>&>(any));
}

/// Errors: std::logic_error if a camera sees a shape with wrong hits, a shape whose convex() is
/// wrong, or a picture that normals place on a shape that is no sphere.
template <class Objects>
void check_objects(const Objects& objects, const Camera& camera) {
  const auto refuse_if = [](bool refused, int index, const char* why) {
    if (refused) throw std::logic_error("object " + std::to_string(index) + ": " + why);
  };
  const View<> view = view_of(camera, 96, 72);
  for (int i = 0; i < 4 * view.width * view.height; ++i) {
    const Ray<double> ray = ray_through<double>(view, i % view.width, i / view.width % view.height);
    const Nearest<double> nearest = find_nearest(objects, ray);
    for_each_hit(objects, ray, nearest, [&](const auto& object, auto hit, bool) {
      refuse_if(roundness(object.shape) == 0 && takes_normal(object.paint), hit.object,
                "it is no sphere: place its picture by a mapping of the Hit, as CylinderMapping");
      if (roundness(object.shape) == 2) return;
      const Vec3d lift = hit.outside - hit.point;
      refuse_if(nearest.distance <= 0, hit.object, "its distance_to is not ahead of the ray");
      const Vec3d along = ray.direction * nearest.distance;
      refuse_if(!(length(hit.point - ray.origin - along) <= 0.01 * length(along)), hit.object,
                "the point of its hit_at is not at distance_to along the ray");
      refuse_if(!(abs(length(hit.normal) - 1) < 1e-6), hit.object, "its normal's length is not 1");
      refuse_if(roundness(object.shape) == 0 && dot(hit.normal, ray.direction) > 0.01, hit.object,
                "its normal does not face the ray");
      refuse_if(
          !(dot(lift, hit.normal) > 0) || length(lift) > 0.01 * length(hit.point - ray.origin),
          hit.object, "`outside` of its hit_at does not lie close above its `point`");
      if (!object.shape.convex()) return;
      const double u = 0.7548776662466927 * i, v = 0.5698402909980532 * i;  // Roberts' sequence
      const Vec3d onward = cosine_direction(hit.normal, Point2<double>{u - floor(u), v - floor(v)});
      refuse_if(distance_to(object.shape, Ray<double>{hit.outside, onward}) < infinity<double>(),
                hit.object,
                "convex() is true, but a ray that leaves it meets it again: see scene/shapes.hpp");
    });
  }
}

}  // namespace texmap
