// Lessons that compute what their scene does not require, and draw the same picture: what chapters
// 01 to 07 leave out; and chapter 08's in two parts.
#pragma once
#include <variant>

#include "01_plain_spheres/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "07_earth_by_sampling/lesson.hpp"
#include "08_triangle_uv/lesson.hpp"
#include "lesson_work.hpp"

namespace texmap::bench {

/// Makes the compiler compute `value`, although nobody uses it.
template <class Value>
inline void keep(const Value& value) {
  asm volatile("" : : "m"(value));
}

/// The color of a paint in programs with a (u, v) in every hit: plain paint gets one, too.
template <class Real>
[[nodiscard]] Color<Real> color_with_uv(const Solid& paint, const Hit<Real>& hit) {
  keep(uv_rtiow(hit.normal));
  return paint(hit);
}
template <class Mapping, class Texture, class Real>
[[nodiscard]] Color<Real> color_with_uv(const Mapped<Mapping, Texture>& paint,
                                        const Hit<Real>& hit) {
  return paint(hit);
}
template <class... Paints, class Real>
[[nodiscard]] Color<Real> color_with_uv(const AnyOf<Paints...>& paint, const Hit<Real>& hit) {
  return std::visit([&hit](const auto& one) { return color_with_uv(one, hit); },
                    static_cast<const std::variant<Paints...>&>(paint));
}

/// Chapter 01's lesson, with a (u, v) in every hit.
struct UvAtEveryHit : chapter_01::Lesson {
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    return color_along(objects, ray, stage.sky, [&](const auto& object, const Hit<Real>& hit) {
      return color_with_uv(object.paint, hit) *
             lambert(surface, sample_light(stage.light, objects, hit));
    });
  }
};

/// A lesson of chapter 01 or 03 that makes the whole hit of every object that a ray meets, with
/// its (u, v) and its color, and forgets all but the nearest.
template <class Lesson>
struct HitOfEveryObject : Lesson {
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    Nearest<Real> nearest;
    Hit<Real> first{};
    Color<Real> paint{};
    double index = 0;
    for (const auto& object : this->objects) {
      const Real distance = distance_to(object.shape, ray);
      const Real place = Real(index);
      index += 1;
      if (!any(distance < infinity<Real>())) continue;
      const Hit<Real> hit =
          hit_at(object.shape, ray, select(distance < infinity<Real>(), distance, Real(1)));
      const Color<Real> color = color_with_uv(object.paint, hit);
      keep(color);
      const Mask<Real> nearer = distance < nearest.distance;
      nearest = {select(nearer, distance, nearest.distance), select(nearer, place, nearest.index)};
      first.normal = select(nearer, hit.normal, first.normal);
      first.point = select(nearer, hit.point, first.point);
      first.outside = select(nearer, hit.outside, first.outside);
      paint = select(nearer, color, paint);
    }
    Color<Real> seen = this->stage.sky(ray);
    index = 0;
    for (std::size_t i = 0; i < this->objects.size(); ++i) {
      const Mask<Real> here = nearest.index == Real(index);
      index += 1;
      if (!any(here)) continue;
      first.object = static_cast<int>(index) - 1;
      const LightSample<Real> light = sample_light(this->stage.light, this->objects, first);
      seen = select(here, paint * lambert(this->surface, light), seen);
    }
    return seen;
  }
};

/// Chapter 06's lesson with a highlight on every object, of strength 0 on those without gloss.
struct HighlightAnyway : chapter_06::Lesson {
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    return color_along(
        objects, ray, stage.sky, [&](const chapter_06::Object& object, const Hit<Real>& hit) {
          const LightSample<Real> light = sample_light(stage.light, phong.casters(objects), hit);
          const Real gloss = texmap::highlight(object.material, light, hit.normal, -ray.direction);
          keep(gloss);
          return object.paint(hit) * lambert(object.material.lambertian, light) + gray(gloss);
        });
  }
};

/// A sky that does not say that it is uniform.
struct UnsureSky {
  const GradientSky& sky;

  [[nodiscard]] static bool is_constant() { return false; }
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    return sky(ray);
  }
};

/// Chapter 07's lesson with what its scene does not require.
///
/// @tparam scatters    follows a path on to a uniform sky
/// @tparam numbers     draws numbers for a lens and for an exposure although it is sharp
/// @tparam everywhere  traces rays also where the globe cannot be seen
template <bool scatters, bool numbers, bool everywhere>
struct Beginner : chapter_07::Lesson {
  static constexpr bool is_traced_everywhere = everywhere;

  template <class Real>
  Color<Real> operator()(const auto& scene, const PixelPlace<Real>& at, auto& random) const {
    const Ray<Real> ray = sampling.lens.ray(scene.view, at, random);
    if constexpr (numbers) {
      keep(random.next_2d());
      keep(random.next_2d());
    }
    const auto through = [&](const auto& sky) {
      return light_along(scene.objects, ray, sky, sampling.bounces, random);
    };
    if constexpr (scatters) return through(UnsureSky{scene.sky});
    return through(scene.sky);
  }
};

/// Chapter 08's lesson without (u, v), texture and light: first hits and shadows alone.
struct TracingAlone : chapter_08::Lesson {
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    const MeshHit<Real> hit = first_hit(scene.mesh, ray);
    return gray(sample_light(stage.light, others(scene.mesh, hit), hit).cosine);
  }
};

}  // namespace texmap::bench
