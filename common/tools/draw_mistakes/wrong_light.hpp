// Lessons of the stage with a mistake in their light.
#pragma once
#include <string>
#include <vector>

#include "math/color.hpp"
#include "scene/light.hpp"
#include "scene/nearest.hpp"

namespace texmap::mistakes {

/// What students do wrong with a lamp. To add one, name it here, in light_mistakes and brightness.
enum class LightMistake {
  not_normalized,    ///< n . (lamp - point), without dividing by the distance
  inward,            ///< the normal points into the sphere
  no_shadows,        ///< no object hides the lamp
  no_limit,          ///< cosines below 0 take light away
  no_ambient,        ///< black where the lamp does not shine
  no_light,          ///< the color alone
  by_the_ray,        ///< the cosine of the ray and the normal
  lamp_not_the_ray,  ///< the direction from the origin to the lamp, whatever the point
};

struct NamedLightMistake {
  LightMistake mistake;
  const char* name;
  const char* words;
};

inline constexpr NamedLightMistake light_mistakes[] = {
    {LightMistake::not_normalized, "light_not_normalized",
     "too bright: the vector to the lamp was not divided by its length"},
    {LightMistake::inward, "normal_inward", "dark where the lamp shines: the normal points inward"},
    {LightMistake::no_shadows, "no_shadows", "without shadows: no ray goes to the lamp"},
    {LightMistake::no_limit, "no_limit",
     "too dark on the far side: cosines below 0 were not limited to 0"},
    {LightMistake::no_ambient, "no_ambient", "black in the shadow: the ambient light is missing"},
    {LightMistake::no_light, "no_light", "without light: the color alone"},
    {LightMistake::by_the_ray, "dark_rim",
     "dark at the outline: the cosine was taken with the ray and not with the lamp"},
    {LightMistake::lamp_not_the_ray, "lamp_far_away",
     "the light comes from one direction everywhere: the lamp's position minus the point is "
     "missing"},
};

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

/// The brightness of the highlight; 0 in a lesson without one.
template <class Lesson, class Object>
[[nodiscard]] double highlight_of(const Lesson& lesson, const Object& object,
                                  const LightSample<double>& light, const Vec3d& normal,
                                  const Ray<double>& ray) {
  if constexpr (HasHighlight<Lesson>) {
    return lesson.phong.highlight(object.material, light, normal, -ray.direction);
  } else {
    return 0;
  }
}

/// A color in a light, as the lesson computes it.
template <class Lesson, class Object>
[[nodiscard]] Rgb lit(const Lesson& lesson, const Object& object, const Rgb& color,
                      const LightSample<double>& light, const Vec3d& normal,
                      const Ray<double>& ray) {
  return color * lambert(lambertian_of(lesson, object), light) +
         gray(highlight_of(lesson, object, light, normal, ray));
}

/// A color in the light that a mistake makes.
template <class Lesson, class Object>
[[nodiscard]] Rgb wrongly_lit(const Lesson& lesson, LightMistake mistake, const Object& object,
                              const Rgb& color, Hit<double> hit, const Ray<double>& ray) {
  const PointLight& lamp = lesson.stage.light;
  const Vec3d path = lamp.position - hit.point;
  const double cosine = dot(hit.normal, normalize(path));  // with any sign, without shadows
  if (mistake == LightMistake::inward) hit.normal = -hit.normal;
  LightSample<double> light = light_at(lesson, hit);
  switch (mistake) {
    case LightMistake::inward:
      break;
    case LightMistake::not_normalized:
      light.cosine *= length(path);
      break;
    case LightMistake::no_shadows:
      light.cosine = max(cosine, 0.0);
      break;
    case LightMistake::no_limit:
      if (cosine < 0) light.cosine = cosine;
      break;
    case LightMistake::no_ambient:
      return lit(lesson, object, color, light, hit.normal, ray) +
             color * -lambertian_of(lesson, object).ambient;
    case LightMistake::no_light:
      return color;
    case LightMistake::by_the_ray:
      light.cosine = abs(dot(hit.normal, ray.direction));
      break;
    case LightMistake::lamp_not_the_ray:
      if (light.cosine > 0) light.cosine = max(dot(hit.normal, normalize(lamp.position)), 0.0);
      break;
  }
  return lit(lesson, object, color, light, hit.normal, ray);
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
