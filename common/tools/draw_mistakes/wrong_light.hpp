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

/// How bright a point is with a mistake.
template <class Lesson>
[[nodiscard]] double brightness(const Lesson& lesson, LightMistake mistake, Hit<double> hit,
                                const Ray<double>& ray) {
  const PointLight& lamp = lesson.stage.light;
  const auto by = [&](double cosine) {
    return lesson.surface.ambient + lesson.surface.diffuse * cosine;
  };
  const Vec3d path = lamp.position - hit.point;
  switch (mistake) {
    case LightMistake::not_normalized:
      return by(sample_light(lamp, lesson.objects, hit).cosine * length(path));
    case LightMistake::inward:
      hit.normal = -hit.normal;
      break;
    case LightMistake::no_shadows:
      return by(max(dot(hit.normal, normalize(path)), 0.0));
    case LightMistake::no_limit: {
      const double cosine = dot(hit.normal, normalize(path));
      return by(cosine < 0 ? cosine : sample_light(lamp, lesson.objects, hit).cosine);
    }
    case LightMistake::no_ambient:
      return lesson.surface.diffuse * sample_light(lamp, lesson.objects, hit).cosine;
    case LightMistake::no_light:
      return 1;
    case LightMistake::by_the_ray:
      return by(abs(dot(hit.normal, ray.direction)));
    case LightMistake::lamp_not_the_ray: {
      const bool hidden = sample_light(lamp, lesson.objects, hit).cosine == 0;
      return by(hidden ? 0 : max(dot(hit.normal, normalize(lamp.position)), 0.0));
    }
  }
  return by(sample_light(lamp, lesson.objects, hit).cosine);
}

/// A lesson of the stage whose light has a mistake.
template <class Lesson>
struct WithLightMistake {
  const Lesson& lesson;
  LightMistake mistake;

  [[nodiscard]] Rgb operator()(const Ray<double>& ray) const {
    return color_along(lesson.objects, ray, lesson.stage.sky,
                       [&](const auto& object, const Hit<double>& hit) {
                         return object.paint(hit) * brightness(lesson, mistake, hit, ray);
                       });
  }
};

}  // namespace texmap::mistakes
