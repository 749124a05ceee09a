// What this chapter draws again and again: chapter 07's globe, the choices that are varied, and the
// scenes that can be drawn with every number: one ray per pixel, and many.
#pragma once
#include <vector>

#include "engine/draw/draw.hpp"
#include "engine/fast/kernel_plan.hpp"
#include "engine/fast/srgb_kernel.hpp"
#include "scene/camera.hpp"
#include "scene/lens.hpp"
#include "scene/path.hpp"
#include "scene/sphere.hpp"
#include "scene/stage.hpp"
#include "texture/bilinear.hpp"

namespace texmap::chapter_13 {

/// How texels become a color.
enum class Filter {
  nearest,   ///< the texel at the place
  bilinear,  ///< the four around it, mixed
};

/// How a color becomes a byte.
enum class Curve {
  none,     ///< the texture's bytes are shown as they are, without any light
  formula,  ///< the sRGB curve by a power
  exact,    ///< the same bytes without a power
  four,     ///< a polynomial of 4 terms: at most 1 level off
  three,    ///< a polynomial of 3 terms: at most 2 levels off
};

/// The globe under a uniform sky, seen from 6 radii as in chapter 07, so near that it fills the
/// picture.
struct Globe {
  Sphere<> sphere{{0, 0, 0}, 2};
  double away = 12;          ///< from the eye to the globe's center
  Rgb sky{0.72, 0.8, 1};     ///< no channel lies on the edge between two bytes
  ImageTexture nearest;      ///< the picture's bytes as they are
  LightTexture light;        ///< the same picture, decoded to light
  BilinearTexture bilinear;  ///< the same picture, filtered

  explicit Globe(const SharedImage& picture)
      : nearest{picture}, light(nearest), bilinear{picture} {}

  /// The view from a place around the globe.
  ///
  /// @param east, up  degrees to the east of chapter 07's, and above the equator, -89 to 89; at 0
  ///                  and 0 a picture's middle row and column look exactly at edges of texels,
  ///                  which no other view does
  [[nodiscard]] View<> view(int width, int height, double east = 12, double up = 17) const;
};

/// One ray a pixel: a globe that shines by itself, or, with a curve, one under the sky's light.
struct OneRayScene {
  const Globe* globe;
  PlannedMapping mapping;
  Filter filter = Filter::nearest;
  Curve curve = Curve::none;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    const Color<Real> color = color_along(ray);
    return {middle_of_byte(color.r), middle_of_byte(color.g), middle_of_byte(color.b)};
  }

  /// What the ray brings: light, or, without a curve, the texture's bytes / 255.
  template <class Real>
  [[nodiscard]] Color<Real> color_along(const Ray<Real>& ray) const {
    const Color<Real> sky = number_cast<Real>(globe->sky);
    const Real distance = distance_to(globe->sphere, ray);
    const Mask<Real> met = distance < infinity<Real>();
    if (!any(met)) return sky;
    const Uv<Real> uv = mapping(normal_at(globe->sphere, ray, select(met, distance, Real(1))));
    if (curve != Curve::none) return select(met, globe->light(uv) * sky, sky);
    return select(met, filter == Filter::nearest ? globe->nearest(uv) : globe->bilinear(uv), sky);
  }

  /// The level of 255 that the curve gives to an amount of light, before it is rounded to a byte.
  template <class Real>
  [[nodiscard]] Real level_of_light(const Real& light) const {
    if (curve == Curve::four) return srgb_level<4>(light);
    if (curve == Curve::three) return srgb_level<3>(light);
    return srgb_encode(clamp(light, Real(0), Real(1))) * Real(255);
  }

 private:
  /// The middle between the channel's byte and the next: truncation to a byte gives its byte.
  template <class Real>
  [[nodiscard]] Real middle_of_byte(const Real& channel) const {
    const Real half = Real(0.5 / 255);
    if (curve == Curve::none) return channel + half;
    return byte_of_light(channel) * Real(1.0 / 255) + half;
  }
  template <class Real>
  [[nodiscard]] Real byte_of_light(const Real& light) const {
    if (curve == Curve::exact) return srgb_byte_exact(light);
    if (curve == Curve::four) return srgb_byte<4>(light);
    if (curve == Curve::three) return srgb_byte<3>(light);
    return floor(level_of_light(light) + Real(0.5));
  }
};

/// Many rays per pixel, spread by a sampler, under the sky's light. Its paint is no Mapped one: no
/// patches are compiled for it.
struct ManyRayScene : GathersLight {
  struct Surface {
    const Globe* globe;
    PlannedMapping uv_of;

    template <class Real>
    [[nodiscard]] Color<Real> operator()(const Hit<Real>& hit) const {
      return globe->light(uv_of(hit.normal));
    }
  };

  std::vector<Painted<Surface>> objects;
  Stage stage;
  Lens lens{};

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const auto& scene, const PixelPlace<Real>& at,
                                       auto& random) const {
    return light_along(scene.objects, lens.ray(scene.view, at, random), scene.sky, 1, random);
  }
};

}  // namespace texmap::chapter_13
