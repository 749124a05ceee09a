// What this chapter draws over and over: chapter 07's globe, in every way that there is to draw it.
#pragma once
#include <vector>

#include "bilinear.hpp"
#include "budget.hpp"
#include "camera.hpp"
#include "gather.hpp"
#include "mapped.hpp"
#include "path.hpp"
#include "scene.hpp"
#include "screen_bounds.hpp"
#include "sphere.hpp"

namespace texmap::chapter_13 {

/// How texels become a color.
enum class Filter {
  nearest,   ///< the texel that holds the place
  bilinear,  ///< the four around it, mixed
};

/// How a color becomes a byte.
enum class Curve {
  none,     ///< the texture's bytes are shown as they are, and nothing is calculated with light
  formula,  ///< the sRGB curve by the C library's power
  exact,    ///< the same bytes without a power
  four,     ///< by a polynomial of 4 terms: at most 1 level off
  three,    ///< by one of 3 terms: at most 2 levels off
};

/// How the light of texels is kept.
enum class Texels {
  bytes,  ///< as the picture has them; a table decodes them
  roots,  ///< as ten-bit roots: root_texture.hpp
};

/// The globe before an even sky, seen from 6 radii as in chapter 07, and so that it fills the picture.
struct Globe {
  Sphere sphere{{0, 0, 0}, 2};
  double away = 12;          ///< from the eye to the globe's center
  Rgb sky{0.72, 0.8, 1};     ///< none of its channels lies on the edge between two bytes
  ImageTexture nearest;      ///< the picture's bytes as they are
  ImageTexture light;        ///< the same picture, decoded to light
  RootTexture roots;         ///< that light, kept as its roots
  BilinearTexture bilinear;  ///< the same picture, filtered

  Globe() = default;
  explicit Globe(const Image& picture)
      : nearest{picture}, light{.image = picture, .light = TexelLight::linear}, roots(light), bilinear{picture} {}

  /// The view from a place round the globe: degrees to the east of chapter 07's, and above the equator, -89 to 89.
  ///
  /// Unless told otherwise from a little beside: from 0 and 0 a picture's middle row and column, if it has them, look at the
  /// very edges of texels, which no other picture does.
  [[nodiscard]] View view(int width, int height, double east = 12, double up = 17) const {
    const double to_radians = std::numbers::pi / 180;
    const double out = away * std::cos(up * to_radians);
    const Point eye{out * std::sin(east * to_radians), away * std::sin(up * to_radians), out * std::cos(east * to_radians)};
    return view_of(Camera{.eye = eye, .target = sphere.center, .fov_y_degrees = 16}, width, height);
  }
};

/// The (u, v) kernel with an arc tangent of that degree; degree 0 is the reference formula, by the C library.
[[nodiscard]] inline BudgetMapping mapping_of_degree(int degree) {
  BudgetMapping mapping;
  mapping.choice.degree = degree;
  return mapping;
}

/// The globe's light at a place, kept in one of the ways.
struct KeptLight {
  const Globe* globe;
  Texels texels = Texels::bytes;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    return texels == Texels::roots ? globe->roots(uv) : globe->light(uv);
  }
};

/// One ray a pixel: a globe that shines by itself, or, with a curve, one under the sky's light.
struct Shot {
  const Globe* globe;
  BudgetMapping mapping;
  Filter filter = Filter::nearest;
  Curve curve = Curve::none;
  Texels texels = Texels::bytes;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    const Color<Real> color = color_along(ray);
    return {to_byte(color.r), to_byte(color.g), to_byte(color.b)};
  }

  /// What the ray brings: light, or, without a curve, the texture's bytes / 255.
  template <class Real>
  [[nodiscard]] Color<Real> color_along(const Ray<Real>& ray) const {
    const Color<Real> sky = number_cast<Real>(globe->sky);
    const Real distance = distance_to(globe->sphere, ray);
    const Mask<Real> met = distance < infinity<Real>();
    if (!any(met)) return sky;
    const Uv<Real> uv = mapping(normal_at(globe->sphere, ray, select(met, distance, Real(1))));
    if (curve != Curve::none) return select(met, KeptLight{globe, texels}(uv)*sky, sky);
    return select(met, filter == Filter::nearest ? globe->nearest(uv) : globe->bilinear(uv), sky);
  }

  /// The level of 255 that the curve gives to an amount of light, before it is rounded to a byte.
  template <class Real>
  [[nodiscard]] Real level_of_light(const Real& light) const {
    if (curve == Curve::four) return srgb_level<4>(light);
    if (curve == Curve::three) return srgb_level<3>(light);
    const Real inside = clamp(light, Real(0), Real(1));
    return from_lanes<Real>([&](std::size_t i) { return srgb_encode(lane(inside, i)); }) * Real(255);
  }

 private:
  /// The channel as the middle between its byte and the next, which is cut off to its byte.
  template <class Real>
  [[nodiscard]] Real to_byte(const Real& channel) const {
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

/// Many rays a pixel, spread by a sampler; what they bring is gathered as light.
struct SampledShot {
  using Paint = Mapped<BudgetMapping, KeptLight>;

  std::vector<Painted<Paint>> objects;
  GradientSky sky;
  Gathering gathering;

  SampledShot(const Globe& globe, const BudgetMapping& mapping, Texels texels, const Gathering& how)
      : objects{{globe.sphere, {mapping, {&globe, texels}}}}, sky{.below = globe.sky, .above = globe.sky}, gathering(how) {}

  [[nodiscard]] Foresight foresight(const View& view) const { return {screen_bounds(view, objects[0].sphere), sky.below}; }
  template <class Real>
  [[nodiscard]] auto ready(const View& view) const {
    return ready_scene<Real>(view, objects, sky);
  }
  template <class Real, class Numbers>
  [[nodiscard]] Color<Real> operator()(const SceneIn<Real, Paint>& scene, const Real& column, const Real& row,
                                       Numbers& numbers) const {
    const auto& in_pixel = numbers.pair();
    const Ray<Real> ray = ray_through(scene.view, column + (in_pixel.u - Real(0.5)), row + (in_pixel.v - Real(0.5)));
    const auto albedo = [](const auto& object, const Hit<Real>& hit) { return object.paint(hit); };
    return light_along(scene.objects, ray, scene.sky, albedo, 1, numbers);
  }
};

}  // namespace texmap::chapter_13
