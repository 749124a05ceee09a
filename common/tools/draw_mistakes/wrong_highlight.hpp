// Chapter 06 with a mistake in its highlight or its blend.
#pragma once
#include <cmath>

#include "wrong_light.hpp"

namespace texmap::mistakes {

/// What students do wrong with a highlight. To add one, name it here, in highlight_mistakes and in
/// wrongly_shining.
enum class HighlightMistake {
  half_vector,     ///< Blinn's, with the same exponent
  colored,         ///< color times (diffuse + specular)
  always_blended,  ///< with and without the option
};

struct NamedHighlightMistake {
  HighlightMistake mistake;
  const char* name;
  const char* words;
};

inline constexpr NamedHighlightMistake highlight_mistakes[] = {
    {HighlightMistake::half_vector, "half_vector",
     "the highlight is too wide: it takes Blinn's half vector and not the reflected light"},
    {HighlightMistake::colored, "colored_highlight",
     "the highlight has the color of the surface: it was multiplied and not added"},
    {HighlightMistake::always_blended, "always_blended",
     "the globe's texture is blended with its light, though nobody asked for a blend"},
};

/// A color with a mistake.
template <class Lesson, class Object>
[[nodiscard]] Rgb wrongly_shining(const Lesson& lesson, HighlightMistake mistake,
                                  const Object& object, const Rgb& color, const Hit<double>& hit,
                                  const Ray<double>& ray) {
  const LightSample<double> light = light_at(lesson, hit);
  const double diffuse = lambert(object.material.lambertian, light);
  const double specular = highlight_of(lesson, object, light, hit.normal, ray);
  switch (mistake) {
    case HighlightMistake::half_vector: {
      if (!(light.cosine > 0)) return color * diffuse;
      const Vec3d half = normalize(light.to_light - ray.direction);
      const double narrowed = std::pow(dot(half, hit.normal), object.material.shininess);
      return color * diffuse + gray(object.material.specular * narrowed);
    }
    case HighlightMistake::colored:
      return color * (diffuse + specular);
    case HighlightMistake::always_blended:
      if (&object != &lesson.objects.front()) break;
      return mix(gray(clamp(diffuse + specular, 0.0, 1.0)), color, lesson.phong.blend);
  }
  return color * diffuse + gray(specular);
}

}  // namespace texmap::mistakes
