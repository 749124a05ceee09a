// The stage with the mistakes of students in it: in its light, the highlight, the blend, the scene
// and the checkerboard's (u, v).
#pragma once
#include <cmath>
#include <utility>

#include "engine/run/planned_highlight.hpp"
#include "math/color.hpp"
#include "scene/phong.hpp"
#include "texture/uv.hpp"

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
  Point lamp, eye;
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
        eye(lesson.stage.camera.eye),
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
  /// With a highlight by the cosine of two other directions.
  [[nodiscard]] Rgb shining(const Vec3d& a, const Vec3d& b) const {
    const double cosine = max(dot(a, b), 0.0);
    const bool shines = light.cosine > 0;
    return color * diffuse() +
           gray(shines ? material.specular * std::pow(cosine, material.shininess) : 0);
  }
  /// The same with another cosine of the light.
  [[nodiscard]] Rgb with_cosine(double other) {
    light.cosine = other;
    return right();
  }
};

/// What students do wrong. To add one, add a row.
struct LightMistake {
  const char* words;
  Rgb (*shade)(Lit lit);
};

inline constexpr LightMistake of_light[] = {
    {"too bright: the vector to the lamp was not divided by its length",
     [](Lit lit) { return lit.with_cosine(lit.light.cosine * length(lit.to_lamp)); }},
    {"too dark on the far side: cosines below 0 were not limited to 0",
     [](Lit lit) { return lit.with_cosine(lit.cosine() < 0 ? lit.cosine() : lit.light.cosine); }},
    {"black in the shadow: the ambient light is missing",
     [](Lit lit) {
       lit.material.lambertian.ambient = 0;
       return lit.right();
     }},
    {"too bright: ambient light was added to the whole of the diffuse light",
     [](Lit lit) {
       lit.material.lambertian.diffuse = 1;
       return lit.right();
     }},
    {"too pale: the curve of image files was applied once too often",
     [](Lit lit) {
       const Rgb color = lit.right();
       return Rgb{std::sqrt(color.r), std::sqrt(color.g), std::sqrt(color.b)};
     }},
    {"the normals as colors: the picture of an earlier step",
     [](Lit lit) {
       const Vec3d half = (lit.normal + Vec3d{1, 1, 1}) * 0.5;
       return Rgb{half.x, half.y, half.z};
     }},
    {"without light: the color alone", [](Lit lit) { return lit.color; }},
    {"dark at the outline: the cosine was taken with the ray and not with the lamp",
     [](Lit lit) { return lit.with_cosine(abs(dot(lit.normal, lit.to_eye))); }},
    {"the light comes from one direction everywhere: the lamp's position minus the point is "
     "missing",
     [](Lit lit) {
       if (lit.light.cosine > 0) lit.light.cosine = max(dot(lit.normal, normalize(lit.lamp)), 0.0);
       return lit.right();
     }},
    {"the light was multiplied twice",
     [](Lit lit) { return lit.color * (lit.diffuse() * lit.diffuse()) + gray(lit.specular()); }},
    {"lit on both sides: the cosine lost its sign",
     [](Lit lit) { return lit.with_cosine(lit.cosine() < 0 ? -lit.cosine() : lit.light.cosine); }},
    {"black in the shadow: a point in the shadow lost its ambient light",
     [](Lit lit) { return lit.light.cosine == 0 ? Rgb{} : lit.right(); }},
    {"lit where it should be dark: the test of the shadow is the wrong way round",
     [](Lit lit) {
       const double cosine = max(lit.cosine(), 0.0);
       return lit.with_cosine(lit.light.cosine == 0 ? cosine : 0);
     }},
    {"flat: the larger of the ambient and the lamp's light was taken, and not their sum",
     [](Lit lit) {
       return lit.color * max(lit.material.lambertian.ambient, lit.light.cosine) +
              gray(lit.specular());
     }},
    {"too soft: the cosine was moved to 0 to 1, (cosine + 1) / 2",
     [](Lit lit) { return lit.with_cosine((lit.cosine() + 1) / 2); }},
    {"pale: the light was added to the color and not multiplied",
     [](Lit lit) { return lit.color + gray(lit.diffuse() + lit.specular()); }},
    {"the globe alone has no light: its color is the texture's",
     [](Lit lit) { return lit.on_globe ? lit.color : lit.right(); }},
    {"dark where the lamp shines: the normal points inward for the light",
     [](Lit lit) { return lit.with_cosine(max(-lit.cosine(), 0.0)); }},
    {"black in the shadow alone: a point in the shadow lost its ambient light",
     [](Lit lit) { return lit.light.cosine == 0 && lit.cosine() > 0 ? Rgb{} : lit.right(); }},
    {"the light falls off too fast: the cosine was squared",
     [](Lit lit) { return lit.with_cosine(lit.light.cosine * lit.light.cosine); }},
    {"dark: the light was divided by the square of the lamp's distance",
     [](Lit lit) { return lit.with_cosine(lit.light.cosine / dot(lit.to_lamp, lit.to_lamp)); }},
};

inline constexpr LightMistake of_highlight[] = {
    {"the highlight is too wide: it takes Blinn's half vector and not the reflected light",
     [](Lit lit) { return lit.shining(normalize(lit.light.to_light + lit.to_eye), lit.normal); }},
    {"the highlight is dark: it was subtracted and not added",
     [](Lit lit) { return lit.color * lit.diffuse() + gray(-lit.specular()); }},
    {"the highlight is too weak at its rim: it was multiplied by the cosine of the light",
     [](Lit lit) { return lit.color * lit.diffuse() + gray(lit.specular() * lit.light.cosine); }},
    {"the highlight lies where the lamp shines straight: (n · l) to the exponent",
     [](Lit lit) { return lit.shining(lit.light.to_light, lit.normal); }},
    {"the highlight is in one place for all points: the way to the eye is the eye's position",
     [](Lit lit) {
       return lit.shining(lit.normal * (2 * lit.cosine()) - lit.light.to_light, normalize(lit.eye));
     }},
    {"the highlight is white: it was multiplied by the exponent",
     [](Lit lit) {
       return lit.color * lit.diffuse() + gray(lit.specular() * lit.material.shininess);
     }},
    {"the highlight has the color of the surface: it was multiplied and not added",
     [](Lit lit) { return lit.color * (lit.diffuse() + lit.specular()); }},
    {"the globe's texture is blended with its light, though nobody asked for a blend",
     [](Lit lit) {
       if (!lit.on_globe) return lit.right();
       return mix(gray(clamp(lit.diffuse() + lit.specular(), 0.0, 1.0)), lit.color,
                  lit.phong.blend);
     }},
};

/// Calls add(words, lesson) with the lesson in each scene that is wrong.
template <class Lesson, class Add>
void of_the_scene(const Lesson& right, const Add& add) {
  const auto with = [&](const char* words, const auto& change) {
    Lesson lesson = right;
    change(lesson);
    add(words, lesson);
  };
  // The first is right for pictures of 4 : 3.
  const auto angle = [&](const char* words, double degrees) {
    with(words, [=](Lesson& lesson) { lesson.stage.camera.fov_y_degrees = degrees; });
  };
  with("the lamp is on the other side: its x has the wrong sign",
       [](Lesson& lesson) { lesson.stage.light.position.x *= -1; });
  with("the lamp is behind the scene: its z has the wrong sign",
       [](Lesson& lesson) { lesson.stage.light.position.z *= -1; });
  with("the lamp is where the eye is",
       [](Lesson& lesson) { lesson.stage.light.position = lesson.stage.camera.eye; });
  with("seen from behind: the eye's z has the wrong sign",
       [](Lesson& lesson) { lesson.stage.camera.eye.z *= -1; });
  with("seen from too low: the eye's y is 0",
       [](Lesson& lesson) { lesson.stage.camera.eye.y = 0; });
  angle("all is too large: the angle of view was taken for the width", 46.826448);
  angle("all is too small: the tangent of the angle of view, and not of its half", 120);
  angle("all is too small: the angle of view is 90 degrees", 90);
  with("the sky is upside down: its colors are exchanged",
       [](Lesson& lesson) { std::swap(lesson.stage.sky.below, lesson.stage.sky.above); });
  with("the sky is missing: rays that meet nothing are black",
       [](Lesson& lesson) { lesson.stage.sky = {.below = {}, .above = {}}; });
  with("the sky has one color: the second is missing",
       [](Lesson& lesson) { lesson.stage.sky.above = lesson.stage.sky.below; });
  with("the sky has one color: the second is missing",
       [](Lesson& lesson) { lesson.stage.sky.below = lesson.stage.sky.above; });
  with("the ground is missing", [](Lesson& lesson) { lesson.objects.pop_back(); });
  with("the left and the right sphere are exchanged",
       [](Lesson& lesson) { std::swap(lesson.objects[1].paint, lesson.objects[2].paint); });
  with("the middle and the right sphere are exchanged",
       [](Lesson& lesson) { std::swap(lesson.objects[0].paint, lesson.objects[2].paint); });
  with("the outer balls are too large: their radius is 1", [](Lesson& lesson) {
    for (const std::size_t i : {1U, 2U}) lesson.objects[i].shape.radius = 1;
  });
  with("the outer balls stand too far back: their z has the wrong sign", [](Lesson& lesson) {
    for (const std::size_t i : {1U, 2U}) lesson.objects[i].shape.center.z *= -1;
  });
  with("the ground is too high: its center is at y = -1000",
       [](Lesson& lesson) { lesson.objects[3].shape.center.y = -1000; });
  if constexpr (HasHighlight<Lesson>) {
    with("the highlight is too strong: its factor is missing",
         [](Lesson& lesson) { lesson.objects.front().material.specular = 1; });
    with("every object has the globe's highlight", [](Lesson& lesson) {
      for (auto& object : lesson.objects) object.material = lesson.objects.front().material;
    });
  }
}

}  // namespace texmap::mistakes
