// The error microscope of the book's cover: one globe in float, its left half by the published
// formulas and its right half by the course's, and what each step of a pixel's calculation gives.
#pragma once
#include <array>
#include <cmath>
#include <numbers>

#include "engine/draw/render.hpp"
#include "number/kinds/double_pair.hpp"
#include "published/uv.hpp"
#include "scene/camera.hpp"
#include "scene/light.hpp"
#include "scene/sphere.hpp"
#include "texture/image_texture.hpp"

namespace texmap::microscope {

/// The square window of `size` x `size` pixels that shows the unit sphere equally large from
/// everywhere. The eye is on the z axis: there a float's ray keeps its digits however far it goes.
///
/// @param radii  from the eye to the surface, more than 0
[[nodiscard]] inline View<> view_from(double radii, int size) {
  const double away = radii + 1;
  const double outline = 1 / std::sqrt(square(away) - 1);  // the tangent of its angle
  return view_of({.eye = {0, 0, -away},
                  .target = {},
                  .fov_y_degrees = 360 / std::numbers::pi * std::atan(1.06 * outline)},
                 size, size);
}

/// Where a ray meets the unit sphere, and its (u, v): by the plain form and Next Week's (u, v), as
/// chapter 14's published globes, or by the hybrid form and the course's, as its robust ones.
template <class Real>
struct Place {
  Real distance;
  Vec3<Real> normal;
  Uv<Real> uv;
};
template <class Real>
[[nodiscard]] Place<Real> place_of(const Ray<Real>& ray, SphereForm form) {
  if (form == SphereForm::hybrid) {
    const auto [distance, normal] = hybrid_meeting<Real>({}, Real(1), ray);
    return {distance, normal, uv_rtiow(normal)};
  }
  const Sphere<> globe{{}, 1, form};
  const Real distance = distance_to(globe, ray);
  const Vec3<Real> normal = normal_at(globe, ray, distance);
  return {distance, normal, published::uv_next_week_v4(normal)};
}

/// b^2, a c, |f x d|^2, b^2 - a c, the distance, u, v, column and row, in this order. What comes
/// after a miss has no meaning, nor have column and row where (u, v) is outside the map.
template <class Real>
using Steps = std::array<Real, 9>;

template <class Real>
[[nodiscard]] Steps<Real> steps_of(const Ray<Real>& ray, SphereForm form, int columns, int rows) {
  const Vec3<Real>& f = ray.origin;
  const Vec3<Real>& d = ray.direction;
  const Real b = -dot(f, d);
  const Real a_c = dot(d, d) * (dot(f, f) - Real(1));
  const Vec3<Real> moment = precise_cross(f, d);
  const Real squared = dot(moment, moment);
  const Real discriminant = form == SphereForm::plain ? b * b - a_c : precise_dot(d, d) - squared;

  const auto [distance, normal, uv] = place_of(ray, form);
  const auto texel = texel_place(uv, columns, rows, VAxis::up, TexelRounding::floor);
  return {b * b,          a_c, squared, discriminant, distance, uv.u, uv.v, Real(texel.column),
          Real(texel.row)};
}

/// The color that a ray sees, under a light from the left and above.
[[nodiscard]] inline Rgb8 color_along(const Ray<float>& ray, SphereForm form,
                                      const ImageTexture& map) {
  const auto [distance, normal, uv] = place_of(ray, form);
  if (!(distance < infinity<float>())) return {20, 24, 33};  // the cover's ground
  if (!(uv.u >= 0 && uv.u < 1 && uv.v >= 0 && uv.v <= 1)) return {255, 0, 255};
  constexpr Vec3<float> to_light{0.28F, 0.46F, -0.84F};
  const float light = lambert(Lambertian{.ambient = 0.15, .diffuse = 0.95},
                              LightSample<float>{to_light, max(dot(normal, to_light), 0.0F)});
  const Color<float> color = map(uv) * light;
  return {byte_of(double(color.r)), byte_of(double(color.g)), byte_of(double(color.b))};
}

/// Rows of the picture of `size` x `size` pixels: half published, half the course's.
[[nodiscard]] inline Image draw(const ImageTexture& map, double radii, int size, int first,
                                int count) {
  const View<> view = view_from(radii, size);
  Image image(size, count);
  for (int row = 0; row < count; ++row) {
    for (int column = 0; column < size; ++column) {
      const auto ray =
          ray_through(view, static_cast<float>(column), static_cast<float>(first + row));
      image.at(column, row) =
          color_along(ray, 2 * column < size ? SphereForm::plain : SphereForm::hybrid, map);
    }
  }
  return image;
}

/// What a pixel's float ray gives: by the published formulas, by the course's, and the true values,
/// by the course's in pairs of doubles, in two parts.
struct Pixel {
  Steps<float> published, ours;
  Steps<DoublePair> right;
};

[[nodiscard]] inline Pixel look(double radii, int size, int column, int row, int columns,
                                int rows) {
  const Ray<float> ray =
      ray_through(view_from(radii, size), static_cast<float>(column), static_cast<float>(row));
  const Ray<DoublePair> exact{number_cast<DoublePair>(ray.origin),
                              number_cast<DoublePair>(ray.direction)};
  return {steps_of(ray, SphereForm::plain, columns, rows),
          steps_of(ray, SphereForm::hybrid, columns, rows),
          steps_of(exact, SphereForm::hybrid, columns, rows)};
}

}  // namespace texmap::microscope
