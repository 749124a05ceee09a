// What a ray meets, with every number between the pixel and its color, for a page.
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/draw/lesson_surfaces.hpp"
#include "engine/files/json.hpp"
#include "scene/light.hpp"
#include "texel_error.hpp"
#include "texture/checkerboard.hpp"
#include "texture/image_texture.hpp"

namespace texmap::live {

using Members = std::vector<std::pair<const char*, Json>>;

[[nodiscard]] inline Json list_of(const Vec3d& v) { return Json::list({v.x, v.y, v.z}); }

/// What a page calls an object of the stage or of the lecture's scene.
[[nodiscard]] inline Json name_of(double x, double radius, bool has_picture) {
  return radius > 50   ? "the ground"
         : has_picture ? "the globe"
         : x == 0      ? "the middle sphere"
         : x < 0       ? "the left sphere"
                       : "the right sphere";
}
/// Name, radius and center of each object.
template <class Lesson>
[[nodiscard]] Json named_objects(const Lesson& lesson) {
  std::vector<Json> objects;
  for (const auto& object : lesson.objects) {
    const Vec3d& center = object.shape.center;
    const double radius = object.shape.radius;
    const bool has_picture = with_paint(object.paint, [](const auto& paint) {
      return requires { inside_of(paint.texture).image; };
    });
    objects.push_back(
        Json::list({name_of(center.x, radius, has_picture), radius, list_of(center)}));
  }
  return Json::list(objects);
}

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
      if (object.material.blends) members.emplace_back("blend", phong.blend);
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

/// How a paint's texture lies flat.
struct FlatShape {
  bool down = false;    ///< whether v runs down
  double aspect = 1;    ///< columns for each row
  double least = 1e-9;  ///< of the width, what a page enlarges: 12 texels or more
};
template <class Paint>
[[nodiscard]] FlatShape flat_shape(const Paint& paint) {
  if constexpr (requires { inside_of(paint.texture).image; }) {
    const auto& texture = inside_of(paint.texture);
    const double width = std::max(1, texture.image.width);
    return {texture.v_axis == VAxis::down, width / std::max(1, texture.image.height), 12 / width};
  }
  return {};
}

/// A part of a texture, laid flat: its edges as shares of the whole, and its points.
struct FlatPart {
  double left, top, width, height;  ///< the whole goes on to the left and right
  int columns, rows;
};
template <class Paint>
[[nodiscard]] Image flat_texture(const Paint& paint, const FlatPart& part) {
  Image image(part.columns, part.rows);
  if constexpr (requires { paint.texture; }) {
    const bool down = flat_shape(paint).down;
    for (int row = 0; row < part.rows; ++row) {
      for (int column = 0; column < part.columns; ++column) {
        const double x = part.left + (column + 0.5) / part.columns * part.width;
        const double y = part.top + (row + 0.5) / part.rows * part.height;
        const Rgb color = paint.texture(Uv<double>{x - std::floor(x), down ? y : 1 - y});
        image.at(column, row) = {byte_of(color.r), byte_of(color.g), byte_of(color.b)};
      }
    }
  }
  return image;
}

/// A pixel on the flat texture: its point, its corners, and the part that a page enlarges; x to the
/// right, y downward, as shares.
///
/// @param places  (u, v) of the point, then of the corners that meet the object
[[nodiscard]] inline Json map_of(int object, const FlatShape& shape,
                                 const std::vector<Uv<double>>& places) {
  const auto y_of = [&](const Uv<double>& uv) { return shape.down ? uv.v : 1 - uv.v; };
  const double x = places.front().u, y = y_of(places.front());
  double reach = shape.least / 4;  // of the corners from the point
  std::vector<Json> corners;
  for (const Uv<double>& uv : places) {
    const double u = uv.u - std::round(uv.u - x);  // on this side of the seam
    reach = std::max({reach, std::abs(u - x), std::abs(y_of(uv) - y) / shape.aspect});
    corners.push_back(Json::list({u, y_of(uv)}));
  }
  corners.erase(corners.begin());
  const double width = std::min({4 * reach, 1.0, 1 / shape.aspect});
  const double height = width * shape.aspect;
  const double top = clamp(y - height / 2, 0.0, 1 - height);
  return Json::object({{"object", object},
                       {"aspect", shape.aspect},
                       {"at", Json::list({x, y})},
                       {"corners", Json::list(corners)},
                       {"detail", Json::list({x - width / 2, top, width, height})}});
}

/// Where a pixel is on the flat texture that its ray meets.
template <class Lesson>
void add_map(const Lesson& lesson, const View<>& view, int column, int row, Members& members) {
  std::vector<Uv<double>> places;
  int object = -1;
  for (const auto& [right, down] :
       {std::pair{0.0, 0.0}, {-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
    const auto met = surface_along(lesson, ray_through(view, column + right, row + down));
    if (places.empty()) object = met.object;
    if (places.empty() && (object < 0 || !met.has_uv())) return;
    if (met.object == object) places.push_back(met.uv);
  }
  const FlatShape shape = with_paint(lesson.objects[static_cast<std::size_t>(object)].paint,
                                     [](const auto& one) { return flat_shape(one); });
  members.emplace_back("map", map_of(object, shape, places));
}

/// Ray, hit, normal, (u, v), texel and light of a ray, as far as there are any.
template <HasObjects Lesson>
[[nodiscard]] Members what_a_ray_meets(const Lesson& lesson, const Ray<double>& ray) {
  Members members{{"eye", list_of(ray.origin)}, {"direction", list_of(ray.direction)}};
  members.emplace_back("objects", named_objects(lesson));
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
