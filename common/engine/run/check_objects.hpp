// Refuses objects of a lesson that would be drawn wrong in silence: shapes that are no spheres.
#pragma once
#include <stdexcept>
#include <string>

#include "sampling/directions.hpp"
#include "scene/camera.hpp"
#include "scene/nearest.hpp"
#include "scene/shapes.hpp"
#include "texture/mapped.hpp"

namespace texmap {

/// A test of the shape that an object has.
template <class Shape, class Test>
[[nodiscard]] bool holds_for(const Shape& shape, const Test& test) {
  if constexpr (requires { shape.with(test); }) {
    return shape.with(test);
  } else {
    return test(shape);
  }
}

/// True for a paint that takes the normal for the direction of the point.
template <class Paint>
[[nodiscard]] bool takes_normal(const Paint&) {
  return false;
}
template <class Mapping, class Texture>
[[nodiscard]] bool takes_normal(const Mapped<Mapping, Texture>&) {
  return !requires(const Mapping& mapping, const Hit<double>& hit) { mapping(hit); };
}
template <class... Paints>
[[nodiscard]] bool takes_normal(const AnyOf<Paints...>& any) {
  return std::visit([](const auto& paint) { return takes_normal(paint); },
                    static_cast<const std::variant<Paints...>&>(any));
}

/// Refuses what `convex` says of a shape if a ray that leaves a point in the camera's view meets it
/// again, and a picture that a shape's normals would place as on a sphere.
/// Errors: std::logic_error with the object's index in the list.
template <class Objects>
void check_objects(const Objects& objects, const Camera& camera) {
  const auto refuse_if = [](bool refused, int index, const char* why) {
    if (refused) throw std::logic_error("object " + std::to_string(index) + ": " + why);
  };
  const auto is_sphere = []<class Shape>(const Shape&) { return SphereLike<Shape>; };
  const auto is_derived = [](const auto& shape) {
    return requires { shape.form; };
  };
  int trusted = 0, index = 0;
  for (const auto& object : objects) {
    trusted += holds_for(object.shape, is_sphere) || !object.shape.convex() ? 1 : 0;
    refuse_if(!holds_for(object.shape, is_derived) && takes_normal(object.paint), index++,
              "its picture is placed by its normals, as on a sphere: take a mapping of the Hit, "
              "such as CylinderMapping in texture/shape_mappings.hpp");
  }
  if (trusted == index) return;
  constexpr int width = 96, height = 72, rays = 8 * width * height;
  const View<> view = view_of(camera, width, height);
  for (int i = 0; i < rays; ++i) {
    const Ray<double> ray = ray_through<double>(view, i % width, i / width % height);
    for_each_hit(objects, ray, find_nearest(objects, ray), [&](const auto& object, auto hit, bool) {
      if (holds_for(object.shape, is_sphere) || !object.shape.convex()) return;
      const double u = 0.7548776662466927 * i, v = 0.5698402909980532 * i;  // Roberts' sequence
      const Vec3d onward = cosine_direction(hit.normal, Point2<double>{u - floor(u), v - floor(v)});
      refuse_if(distance_to(object.shape, Ray<double>{hit.outside, onward}) < infinity<double>(),
                hit.object,
                "convex() is true, but a ray that leaves it meets it again: is the shape open or "
                "bent inward, or is `outside` not lifted enough? (scene/shapes.hpp)");
    });
  }
}

}  // namespace texmap
