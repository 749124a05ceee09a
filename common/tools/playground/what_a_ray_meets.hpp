// What a ray meets, with every number between the pixel and its color, for a page.
#pragma once
#include <cmath>
#include <utility>
#include <vector>

#include "engine/measure/json.hpp"
#include "engine/render/surfaces.hpp"
#include "scene/light.hpp"
#include "texel_error.hpp"
#include "texture/checkerboard.hpp"
#include "texture/image_texture.hpp"

namespace texmap::live {

using Members = std::vector<std::pair<const char*, Json>>;

[[nodiscard]] inline Json list_of(const Vec3d& v) { return Json::list({v.x, v.y, v.z}); }

/// What a texture has at (u, v): the texel of a picture, or the square of a checkerboard.
template <class Paint>
void add_texel(const Paint& paint, const Uv<double>& uv, Members& members) {
  if constexpr (requires { inside_of(paint.texture).rounding; }) {
    const auto& texture = inside_of(paint.texture);
    const Image& image = texture.image;
    const TexelPlace<double> place =
        texel_place(uv, image.width, image.height, texture.v_axis, texture.rounding);
    const Rgb8& texel = image.at(place.column, place.row);
    members.emplace_back(
        "texel", Json::object({{"column", place.column},
                               {"row", place.row},
                               {"width", image.width},
                               {"height", image.height},
                               {"down", texture.v_axis == VAxis::down},
                               {"floor", texture.rounding == TexelRounding::floor},
                               {"color", Json::list({int{texel.r}, int{texel.g}, int{texel.b}})}}));
  } else if constexpr (requires { paint.texture.squares; }) {
    members.emplace_back("squares", paint.texture.squares);
  }
}

/// The rotation of a paint's mapping, as sine and cosine, and the normal after it.
template <class Paint>
void add_rotation(const Paint& paint, const Vec3d& normal, Members& members) {
  if constexpr (requires { paint.mapping.rotation.sine; }) {
    const auto& rotation = paint.mapping.rotation;
    members.emplace_back("turn", Json::list({rotation.sine, rotation.cosine}));
    members.emplace_back("rotated", list_of(rotation(normal)));
  }
}

/// Where a paint is read: (u, v), texel and, if the mapping turns with its object, the normal.
template <class Paint, class AnyHit>
void add_place(const Paint& paint, const AnyHit& hit, Members& members) {
  const Uv<double> uv = uv_of_paint(paint, hit);
  if (std::isnan(uv.u)) return;
  members.emplace_back("uv", Json::list({uv.u, uv.v}));
  with_paint(paint, [&](const auto& one) {
    add_rotation(one, hit.normal, members);
    add_texel(one, uv, members);
  });
}

/// The light that arrives.
template <class Objects>
LightSample<double> add_light(const PointLight& lamp, const Objects& objects,
                              const Hit<double>& hit, Members& members) {
  const auto light = sample_light(lamp, objects, hit);
  members.emplace_back("to_light", list_of(light.to_light));
  members.emplace_back("cosine", light.cosine);
  return light;
}

/// What becomes of the light: a Lambertian surface's share, and in later chapters a highlight.
template <class Lesson, class Object>
void add_shading(const Lesson& lesson, const Object& object, const Hit<double>& hit,
                 const Vec3d& direction, Members& members) {
  Lambertian matte;
  if constexpr (requires { lesson.phong; }) {
    const auto& phong = lesson.phong;
    const auto light = add_light(lesson.stage.light, phong.casters(lesson.objects), hit, members);
    matte = object.material.lambertian;
    if (object.material.specular > 0) {
      members.emplace_back("mirrored", list_of(mirror(light.to_light, hit.normal)));
      members.emplace_back("specular", object.material.specular);
      members.emplace_back("shininess", object.material.shininess);
      members.emplace_back("highlight",
                           phong.highlight(object.material, light, hit.normal, -direction));
      if (phong.blends) members.emplace_back("blend", phong.blend);
    }
  } else {
    add_light(lesson.stage.light, lesson.objects, hit, members);
    matte = lesson.surface;
  }
  members.emplace_back("ambient", matte.ambient);
  members.emplace_back("diffuse", matte.diffuse);
  const Color<double> paint = object.paint(hit);
  members.emplace_back("paint", Json::list({255 * paint.r, 255 * paint.g, 255 * paint.b}));
}

/// Ray, hit, normal, (u, v), texel and light of a ray, as far as there are any.
template <HasObjects Lesson>
[[nodiscard]] Members what_a_ray_meets(const Lesson& lesson, const Ray<double>& ray) {
  Members members{{"eye", list_of(ray.origin)}, {"direction", list_of(ray.direction)}};
  const Nearest<double> nearest = find_nearest(lesson.objects, ray);
  if (nearest.index >= 0) {
    const auto& object = lesson.objects[static_cast<std::size_t>(nearest.index)];
    Hit<double> hit = hit_at(object.shape, ray, nearest.distance);
    hit.object = static_cast<int>(nearest.index);
    members.emplace_back("object", hit.object);
    members.emplace_back("distance", nearest.distance);
    members.emplace_back("point", list_of(hit.point));
    members.emplace_back("center", list_of(object.shape.center));
    members.emplace_back("radius", object.shape.radius);
    members.emplace_back("normal", list_of(hit.normal));
    add_place(object.paint, hit, members);
    if constexpr (
        requires { lesson.surface; } || requires { object.material; })
      add_shading(lesson, object, hit, ray.direction, members);
  }
  return members;
}

}  // namespace texmap::live
