// Lessons of the stage with a mistake in their light, their highlight or their blend.
#pragma once
#include <cmath>

#include "math/color.hpp"
#include "scene/light.hpp"
#include "scene/nearest.hpp"

namespace texmap::mistakes {

/// Lessons whose objects have a highlight.
template <class Lesson>
concept HasHighlight = requires(const Lesson& lesson) {
  lesson.phong;
  lesson.objects.front().material.lambertian;
};

/// The light that arrives, with the shadows that the lesson has.
template <class Lesson>
[[nodiscard]] LightSample<double> light_at(const Lesson& lesson, const Hit<double>& hit) {
  if constexpr (HasHighlight<Lesson>) {
    return sample_light(lesson.stage.light, lesson.phong.casters(lesson.objects), hit);
  } else {
    return sample_light(lesson.stage.light, lesson.objects, hit);
  }
}

template <class Lesson, class Object>
[[nodiscard]] const Lambertian& lambertian_of(const Lesson& lesson, const Object& object) {
  if constexpr (HasHighlight<Lesson>) {
    return object.material.lambertian;
  } else {
    return lesson.surface;
  }
}

/// A color in a light, as the lesson computes it.
template <class Lesson, class Object>
[[nodiscard]] Rgb lit(const Lesson& lesson, const Object& object, const Rgb& color,
                      const LightSample<double>& light, const Vec3d& normal,
                      const Ray<double>& ray) {
  const Rgb diffuse = color * lambert(lambertian_of(lesson, object), light);
  if constexpr (HasHighlight<Lesson>) {
    return diffuse + gray(lesson.phong.highlight(object.material, light, normal, -ray.direction));
  } else {
    return diffuse;
  }
}

/// What students do wrong with a lamp: calls `add(name, words, shade)` for each, where
/// `shade(object, hit, ray)` is the color that the mistake makes. To add one, add a call.
template <class Lesson, class Add>
void for_each_light_mistake(const Lesson& lesson, const Add& add) {
  const Point lamp = lesson.stage.light.position;
  // The lesson's color in the light that `change(light, hit, ray)` leaves.
  const auto with = [&lesson](const auto& change) {
    return [&lesson, change](const auto& object, const Hit<double>& hit, const auto& ray) {
      LightSample<double> light = light_at(lesson, hit);
      change(light, hit, ray);
      return lit(lesson, object, object.paint(hit), light, hit.normal, ray);
    };
  };
  // With any sign, without shadows.
  const auto cosine = [lamp](const Hit<double>& hit) {
    return dot(hit.normal, normalize(lamp - hit.point));
  };
  add("light_not_normalized", "too bright: the vector to the lamp was not divided by its length",
      with([=](auto& light, const auto& hit, const auto&) {
        light.cosine *= length(lamp - hit.point);
      }));
  add("normal_inward", "dark where the lamp shines: the normal points inward",
      [&lesson](const auto& object, Hit<double> hit, const auto& ray) {
        const Rgb color = object.paint(hit);
        hit.normal = -hit.normal;
        return lit(lesson, object, color, light_at(lesson, hit), hit.normal, ray);
      });
  add("no_shadows", "without shadows: no ray goes to the lamp",
      with([=](auto& light, const auto& hit, const auto&) {
        light.cosine = max(cosine(hit), 0.0);
      }));
  add("no_limit", "too dark on the far side: cosines below 0 were not limited to 0",
      with([=](auto& light, const auto& hit, const auto&) {
        if (cosine(hit) < 0) light.cosine = cosine(hit);
      }));
  add("no_ambient", "black in the shadow: the ambient light is missing",
      [&lesson](const auto& object, const Hit<double>& hit, const auto& ray) {
        const Rgb color = object.paint(hit);
        return lit(lesson, object, color, light_at(lesson, hit), hit.normal, ray) +
               color * -lambertian_of(lesson, object).ambient;
      });
  add("no_light", "without light: the color alone",
      [](const auto& object, const Hit<double>& hit, const auto&) -> Rgb {
        return object.paint(hit);
      });
  add("dark_rim", "dark at the outline: the cosine was taken with the ray and not with the lamp",
      with([](auto& light, const auto& hit, const auto& ray) {
        light.cosine = abs(dot(hit.normal, ray.direction));
      }));
  add("lamp_far_away",
      "the light comes from one direction everywhere: the lamp's position minus the point is "
      "missing",
      with([=](auto& light, const auto& hit, const auto&) {
        if (light.cosine > 0) light.cosine = max(dot(hit.normal, normalize(lamp)), 0.0);
      }));
}

/// The same for a highlight and a blend.
template <HasHighlight Lesson, class Add>
void for_each_highlight_mistake(const Lesson& lesson, const Add& add) {
  // The color that `mix_up(object, color, diffuse, specular, light, hit, ray)` makes.
  const auto with = [&lesson](const auto& mix_up) {
    return [&lesson, mix_up](const auto& object, const Hit<double>& hit, const auto& ray) -> Rgb {
      const LightSample<double> light = light_at(lesson, hit);
      const double diffuse = lambert(object.material.lambertian, light);
      const double specular =
          lesson.phong.highlight(object.material, light, hit.normal, -ray.direction);
      return mix_up(object, object.paint(hit), diffuse, specular, light, hit, ray);
    };
  };
  add("half_vector",
      "the highlight is too wide: it takes Blinn's half vector and not the reflected light",
      with([](const auto& object, const Rgb& color, double diffuse, double, const auto& light,
              const auto& hit, const auto& ray) {
        if (!(light.cosine > 0)) return color * diffuse;
        const Vec3d half = normalize(light.to_light - ray.direction);
        const double narrowed = std::pow(dot(half, hit.normal), object.material.shininess);
        return color * diffuse + gray(object.material.specular * narrowed);
      }));
  add("colored_highlight",
      "the highlight has the color of the surface: it was multiplied and not added",
      with([](const auto&, const Rgb& color, double diffuse, double specular, const auto&...) {
        return color * (diffuse + specular);
      }));
  add("always_blended",
      "the globe's texture is blended with its light, though nobody asked for a blend",
      with([&lesson](const auto& object, const Rgb& color, double diffuse, double specular,
                     const auto&...) {
        if (&object != &lesson.objects.front()) return color * diffuse + gray(specular);
        return mix(gray(clamp(diffuse + specular, 0.0, 1.0)), color, lesson.phong.blend);
      }));
}

/// A lesson of the stage that gives a hit another color: `shade(object, hit, ray)`.
template <class Lesson, class Shade>
struct WithShade {
  const Lesson& lesson;
  Shade shade;

  [[nodiscard]] Rgb operator()(const Ray<double>& ray) const {
    return color_along(
        lesson.objects, ray, lesson.stage.sky,
        [&](const auto& object, const Hit<double>& hit) { return shade(object, hit, ray); });
  }
};

}  // namespace texmap::mistakes
