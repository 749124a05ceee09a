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
  /// The same with another cosine of the light.
  [[nodiscard]] Rgb with_cosine(double other) {
    light.cosine = other;
    return right();
  }
};

/// What students do wrong. To add one, add a row.
struct LightMistake {
  const char *name, *words;
  Rgb (*shade)(Lit lit);
};

constexpr LightMistake of_light[] = {
    {"light_not_normalized", "too bright: the vector to the lamp was not divided by its length",
     [](Lit lit) { return lit.with_cosine(lit.light.cosine * length(lit.to_lamp)); }},
    {"no_shadows", "without shadows: no ray goes to the lamp",
     [](Lit lit) { return lit.with_cosine(max(lit.cosine(), 0.0)); }},
    {"no_limit", "too dark on the far side: cosines below 0 were not limited to 0",
     [](Lit lit) { return lit.with_cosine(lit.cosine() < 0 ? lit.cosine() : lit.light.cosine); }},
    {"no_ambient", "black in the shadow: the ambient light is missing",
     [](Lit lit) {
       lit.material.lambertian.ambient = 0;
       return lit.right();
     }},
    {"ambient_added", "too bright: ambient light was added to the whole of the diffuse light",
     [](Lit lit) {
       lit.material.lambertian.diffuse = 1;
       return lit.right();
     }},
    {"root", "too pale: the curve of image files was applied once too often",
     [](Lit lit) {
       const Rgb color = lit.right();
       return Rgb{std::sqrt(color.r), std::sqrt(color.g), std::sqrt(color.b)};
     }},
    {"normals", "the normals as colors: the picture of an earlier step",
     [](Lit lit) {
       const Vec3d half = (lit.normal + Vec3d{1, 1, 1}) * 0.5;
       return Rgb{half.x, half.y, half.z};
     }},
    {"no_light", "without light: the color alone", [](Lit lit) { return lit.color; }},
    {"dark_rim", "dark at the outline: the cosine was taken with the ray and not with the lamp",
     [](Lit lit) { return lit.with_cosine(abs(dot(lit.normal, lit.to_eye))); }},
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

/// Calls add(name, words, lesson) with the lesson in each scene that is wrong.
template <class Lesson, class Add>
void of_the_scene(const Lesson& right, const Add& add) {
  const auto with = [&](const char* name, const char* words, const auto& change) {
    Lesson lesson = right;
    change(lesson);
    add(name, words, lesson);
  };
  // The first is right for pictures of 4 : 3.
  const auto angle = [&](const char* name, const char* words, double degrees) {
    with(name, words, [=](Lesson& lesson) { lesson.stage.camera.fov_y_degrees = degrees; });
  };
  with("lamp_x", "the lamp is on the other side: its x has the wrong sign",
       [](Lesson& lesson) { lesson.stage.light.position.x *= -1; });
  with("lamp_z", "the lamp is behind the scene: its z has the wrong sign",
       [](Lesson& lesson) { lesson.stage.light.position.z *= -1; });
  with("lamp_at_eye", "the lamp is where the eye is",
       [](Lesson& lesson) { lesson.stage.light.position = lesson.stage.camera.eye; });
  with("eye_z", "seen from behind: the eye's z has the wrong sign",
       [](Lesson& lesson) { lesson.stage.camera.eye.z *= -1; });
  with("eye_y", "seen from too low: the eye's y is 0",
       [](Lesson& lesson) { lesson.stage.camera.eye.y = 0; });
  angle("angle_of_width", "all is too large: the angle of view was taken for the width", 46.826448);
  angle("angle_twice", "all is too small: the tangent of the angle of view, and not of its half",
        120);
  angle("angle_90", "all is too small: the angle of view is 90 degrees", 90);
  with("sky_upside_down", "the sky is upside down: its colors are exchanged",
       [](Lesson& lesson) { std::swap(lesson.stage.sky.below, lesson.stage.sky.above); });
  with("sky_black", "the sky is missing: rays that meet nothing are black",
       [](Lesson& lesson) { lesson.stage.sky = {.below = {}, .above = {}}; });
  with("sky_below", "the sky has one color: the second is missing",
       [](Lesson& lesson) { lesson.stage.sky.above = lesson.stage.sky.below; });
  with("sky_above", "the sky has one color: the second is missing",
       [](Lesson& lesson) { lesson.stage.sky.below = lesson.stage.sky.above; });
  with("no_ground", "the ground is missing", [](Lesson& lesson) { lesson.objects.pop_back(); });
  with("exchanged_paints", "the left and the right sphere are exchanged",
       [](Lesson& lesson) { std::swap(lesson.objects[1].paint, lesson.objects[2].paint); });
  with("middle_and_right", "the middle and the right sphere are exchanged",
       [](Lesson& lesson) { std::swap(lesson.objects[0].paint, lesson.objects[2].paint); });
  if constexpr (HasHighlight<Lesson>) {
    with("strong_highlight", "the highlight is too strong: its factor is missing",
         [](Lesson& lesson) { lesson.objects.front().material.specular = 1; });
    with("all_shine", "every object has the globe's highlight", [](Lesson& lesson) {
      for (auto& object : lesson.objects) object.material = lesson.objects.front().material;
    });
  }
}

/// A wrong place on the checkerboard, from the right one and the height of the normal.
struct UvMistake {
  const char *name, *words;
  Uv<double> (*uv)(Uv<double> uv, double y);
};

constexpr UvMistake of_uv[] = {
    {"v_by_height", "squeezed at the poles: v was taken from the height, without the angle",
     [](Uv<double> uv, double y) -> Uv<double> {
       return {uv.u, (y + 1) / 2};
     }},
    {"half_as_many", "half as many squares: 5 for 10, or u and v only reach 1/2",
     [](Uv<double> uv, double) -> Uv<double> {
       return {uv.u / 2, uv.v / 2};
     }},
    {"twice_as_many", "twice as many squares: 20 for 10, or u and v reach 2",
     [](Uv<double> uv, double) -> Uv<double> {
       return {2 * uv.u - std::floor(2 * uv.u), 2 * uv.v - std::floor(2 * uv.v)};
     }},
    {"twice_around", "twice around: u covers 0 to 2, or it was divided by pi and not by 2 pi",
     [](Uv<double> uv, double) -> Uv<double> {
       return {uv.u * 2, uv.v};
     }},
};

}  // namespace texmap::mistakes
