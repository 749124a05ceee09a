// The globe as scenes that can be drawn with every number: one ray per pixel, and many.
#pragma once
#include <vector>

#include "engine/kernels/kernel_plan.hpp"
#include "engine/kernels/srgb_kernel.hpp"
#include "engine/render/draw.hpp"
#include "globe.hpp"
#include "scene/lens.hpp"
#include "scene/path.hpp"
#include "scene/stage.hpp"

namespace texmap::chapter_13 {

/// The globe's light at a place on the texture.
struct StoredLight {
  const Globe* globe;
  TexelFormat format = TexelFormat::bytes;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    return format == TexelFormat::roots ? globe->roots(uv) : globe->light(uv);
  }
};

/// One ray a pixel: a globe that shines by itself, or, with a curve, one under the sky's light.
struct OneRayScene {
  const Globe* globe;
  PlannedMapping mapping;
  Filter filter = Filter::nearest;
  Curve curve = Curve::none;
  TexelFormat format = TexelFormat::bytes;

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
    if (curve != Curve::none) return select(met, StoredLight{globe, format}(uv)*sky, sky);
    return select(met, filter == Filter::nearest ? globe->nearest(uv) : globe->bilinear(uv), sky);
  }

  /// The level of 255 that the curve gives to an amount of light, before it is rounded to a byte.
  template <class Real>
  [[nodiscard]] Real level_of_light(const Real& light) const {
    if (curve == Curve::four) return srgb_level<4>(light);
    if (curve == Curve::three) return srgb_level<3>(light);
    const Real inside = clamp(light, Real(0), Real(1));
    return from_lanes<Real>([&](std::size_t i) { return srgb_encode(lane(inside, i)); }) *
           Real(255);
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

/// One ray a pixel without a curve, by the reference formula: what variants are compared with.
struct ReferenceScene {
  const Globe* globe;
  Filter filter;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    const Real distance = distance_to(globe->sphere, ray);
    Color<Real> color = number_cast<Real>(globe->sky);
    if (distance < infinity<Real>()) {
      const Uv<Real> uv = uv_rtiow(normal_at(globe->sphere, ray, distance));
      color = filter == Filter::nearest ? globe->nearest(uv) : globe->bilinear(uv);
    }
    return color + gray(Real(0.5 / 255));  // the middle of its byte: see OneRayScene
  }
};

/// Many rays per pixel, spread by a sampler, under the sky's light.
struct ManyRayScene {
  /// A paint that hides its mapping: no patches are compiled for it.
  struct Surface {
    PlannedMapping uv_of;
    StoredLight light;

    template <class Real>
    [[nodiscard]] Color<Real> operator()(const Hit<Real>& hit) const {
      return light(uv_of(hit.normal));
    }
  };

  std::vector<Painted<Surface>> objects;
  Stage stage;
  struct {
    Lens lens;
  } sampling{};

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const auto& scene, const PixelPlace<Real>& at,
                                       auto& random) const {
    return light_along(scene.objects, sampling.lens.ray(scene.view, at, random), scene.sky, 1, random);
  }
};

}  // namespace texmap::chapter_13
