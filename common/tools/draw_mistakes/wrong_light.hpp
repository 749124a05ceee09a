// The light of the stage with the mistakes of students in it, in the highlight or in the blend.
#pragma once
#include <cmath>

#include "engine/app/planned_highlight.hpp"
#include "math/color.hpp"
#include "scene/phong.hpp"

namespace texmap::mistakes {

/// Lessons whose objects have a highlight.
template <class Lesson>
concept HasHighlight = requires(const Lesson& lesson) {
  lesson.phong;
  lesson.objects.front().material.lambertian;
};

/// What a lesson computes the color of a hit from, for a mistake to change.
struct Lit {
  Rgb color;  ///< of the paint
  Point lamp;
  Vec3d to_lamp;  ///< not of length 1
  Vec3d normal, to_eye;
  bool on_globe;
  PhongOptions phong{};
  PhongMaterial material{};     ///< without a highlight where the lesson has none
  LightSample<double> light{};  ///< with the shadows that the lesson has

  template <class Lesson, class Object>
  Lit(const Lesson& lesson, const Object& object, const Rgb& own_color, const Hit<double>& hit,
      const Ray<double>& ray)
      : color(own_color),
        lamp(lesson.stage.light.position),
        to_lamp(lamp - hit.point),
        normal(hit.normal),
        to_eye(-ray.direction),
        on_globe(&object == &lesson.objects.front()) {
    if constexpr (HasHighlight<Lesson>) {
      phong = lesson.phong;
      material = object.material;
      light = sample_light(lesson.stage.light, phong.casters(lesson.objects), hit);
    } else {
      material.lambertian = lesson.surface;
      light = sample_light(lesson.stage.light, lesson.objects, hit);
    }
  }
  /// With any sign, without shadows.
  [[nodiscard]] double cosine() const { return dot(normal, normalize(to_lamp)); }
  [[nodiscard]] double diffuse() const { return lambert(material.lambertian, light); }
  [[nodiscard]] double specular() const { return phong.highlight(material, light, normal, to_eye); }
  /// As the lesson computes it.
  [[nodiscard]] Rgb right() const { return color * diffuse() + gray(specular()); }
};

/// What students do wrong. To add one, add a row.
struct LightMistake {
  const char *name, *words;
  Rgb (*shade)(Lit lit);
};

constexpr LightMistake of_light[] = {
    {"light_not_normalized", "too bright: the vector to the lamp was not divided by its length",
     [](Lit lit) {
       lit.light.cosine *= length(lit.to_lamp);
       return lit.right();
     }},
    {"no_shadows", "without shadows: no ray goes to the lamp",
     [](Lit lit) {
       lit.light.cosine = max(lit.cosine(), 0.0);
       return lit.right();
     }},
    {"no_limit", "too dark on the far side: cosines below 0 were not limited to 0",
     [](Lit lit) {
       if (lit.cosine() < 0) lit.light.cosine = lit.cosine();
       return lit.right();
     }},
    {"no_ambient", "black in the shadow: the ambient light is missing",
     [](Lit lit) {
       lit.material.lambertian.ambient = 0;
       return lit.right();
     }},
    {"no_light", "without light: the color alone", [](Lit lit) { return lit.color; }},
    {"dark_rim", "dark at the outline: the cosine was taken with the ray and not with the lamp",
     [](Lit lit) {
       lit.light.cosine = abs(dot(lit.normal, lit.to_eye));
       return lit.right();
     }},
    {"lamp_far_away",
     "the light comes from one direction everywhere: the lamp's position minus the point is "
     "missing",
     [](Lit lit) {
       if (lit.light.cosine > 0) lit.light.cosine = max(dot(lit.normal, normalize(lit.lamp)), 0.0);
       return lit.right();
     }},
};

constexpr LightMistake of_highlight[] = {
    {"half_vector",
     "the highlight is too wide: it takes Blinn's half vector and not the reflected light",
     [](Lit lit) {
       const Vec3d half = normalize(lit.light.to_light + lit.to_eye);
       const double narrowed = std::pow(dot(half, lit.normal), lit.material.shininess);
       const bool shines = lit.light.cosine > 0;
       return lit.color * lit.diffuse() + gray(shines ? lit.material.specular * narrowed : 0);
     }},
    {"colored_highlight",
     "the highlight has the color of the surface: it was multiplied and not added",
     [](Lit lit) { return lit.color * (lit.diffuse() + lit.specular()); }},
    {"always_blended",
     "the globe's texture is blended with its light, though nobody asked for a blend",
     [](Lit lit) {
       if (!lit.on_globe) return lit.right();
       return mix(gray(clamp(lit.diffuse() + lit.specular(), 0.0, 1.0)), lit.color,
                  lit.phong.blend);
     }},
};

}  // namespace texmap::mistakes
