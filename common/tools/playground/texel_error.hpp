// Where float puts the texture in another place than double does, in texels.
#pragma once
#include <algorithm>
#include <cmath>
#include <variant>

#include "engine/draw/lesson.hpp"
#include "engine/draw/lesson_surfaces.hpp"
#include "engine/draw/render.hpp"
#include "math/color.hpp"
#include "scene/camera.hpp"
#include "texture/image.hpp"

namespace texmap::live {

/// Calls `use` with a paint, or with the one that an AnyOf holds.
template <class Paint, class Use>
auto with_paint(Paint& paint, const Use& use) {
  if constexpr (requires { paint.index(); }) {
    return std::visit(use, paint);
  } else {
    return use(paint);
  }
}

/// The texture inside of one that goes on beyond its edges; another itself.
template <class Texture>
[[nodiscard]] const auto& inside_of(const Texture& texture) {
  if constexpr (requires { texture.wrapped; }) {
    return texture.wrapped.texture;
  } else {
    return texture;
  }
}

/// The texels of a paint's picture, columns and rows; the Earth's where it has none.
template <class Paint>
[[nodiscard]] Size texels_of(const Paint& paint) {
  if constexpr (requires { inside_of(paint.texture).image; }) {
    const Image& image = inside_of(paint.texture).image;
    return {image.width, image.height};
  } else {
    return {2048, 1024};
  }
}

/// How far two places on a picture are apart, in texels; u = 0 and u = 1 are the same place.
[[nodiscard]] inline double texels_apart(const Uv<double>& a, const Uv<double>& b, Size texels) {
  const double across = std::abs(a.u - b.u);
  return std::hypot(std::min(across, 1 - across) * texels.width, (a.v - b.v) * texels.height);
}

/// An error as a color: blue for 1e-5 texel or less, through red, to yellow for 1 or more.
[[nodiscard]] inline Rgb color_of_error(double texels) {
  const Rgb least{0.1, 0.15, 0.5}, middle{0.85, 0.15, 0.25}, most{1, 0.95, 0.3};
  const double t = clamp(std::log10(std::max(texels, 1e-9)) / 5 + 1, 0.0, 1.0);
  return t < 0.5 ? mix(least, middle, 2 * t) : mix(middle, most, 2 * t - 1);
}

/// What float finds at a pixel, and how far that is from what double finds.
struct TexelError {
  int object;     ///< met by float; -1: the sky
  bool same;      ///< whether double meets that object, too
  bool has_uv;    ///< whether both have a place on a texture
  Uv<double> uv;  ///< by float
  double apart;   ///< in texels
};

template <class Lesson>
[[nodiscard]] TexelError texel_error(const Lesson& lesson, const View<>& view, int column,
                                     int row) {
  const auto right = surface_along(lesson, ray_through(view, double(column), double(row)));
  const auto drawn =
      surface_along(lesson, ray_through(view, static_cast<float>(column), static_cast<float>(row)));
  TexelError error{drawn.object, drawn.object == right.object, false, {}, 0};
  if (!error.same || right.object < 0 || !right.has_uv()) return error;
  error.has_uv = true;
  error.uv = {double(drawn.uv.u), double(drawn.uv.v)};
  const auto& paint = lesson.objects[static_cast<std::size_t>(right.object)].paint;
  const Size texels = with_paint(paint, [](const auto& one) { return texels_of(one); });
  error.apart = texels_apart(error.uv, right.uv, texels);
  return error;
}

/// The error of a pixel: black for the sky, gray where there is no (u, v), white where float meets
/// another object than double.
[[nodiscard]] inline Rgb color_of_texel_error(const TexelError& error) {
  if (!error.same) return gray(1.0);
  if (error.object < 0) return gray(0.0);
  return error.has_uv ? color_of_error(error.apart) : gray(0.3);
}

/// The errors of all pixels.
template <class Lesson>
[[nodiscard]] Image draw_errors(const Lesson& lesson, const View<>& view) {
  Image image(view.width, view.height);
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const Rgb color = color_of_texel_error(texel_error(lesson, view, column, row));
      image.at(column, row) = {byte_of(color.r), byte_of(color.g), byte_of(color.b)};
    }
  }
  return image;
}

}  // namespace texmap::live
