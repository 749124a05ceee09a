// Phong's highlight.
#pragma once
#include "math/color.hpp"
#include "scene/light.hpp"

namespace texmap {

/// A Lambertian material with a highlight.
struct PhongMaterial {
  Lambertian lambertian;
  double specular = 0;    ///< strength of the highlight, 0 to 1
  double shininess = 50;  ///< Phong's exponent, 0 to 1e30: the larger, the smaller the highlight
  bool blends = false;    ///< the paint is mixed with its light, and not multiplied by it
};

/// An object of a scene: a shape, its paint and its material.
template <class Paint, class Shape = Sphere<>>
struct Shiny {
  Shape shape;
  Paint paint;
  PhongMaterial material{};
};

/// Which formula computes the highlight.
enum class HighlightFormula {
  phong,    ///< towards the eye, only where the light shines
  lecture,  ///< as on the lecture's slides: away from the eye, even in shadow
};

/// A direction mirrored at a surface: 2 (n . d) n - d.
template <class Real>
[[nodiscard]] Vec3<Real> mirror(const Vec3<Real>& direction, const Vec3<Real>& normal) {
  return normal * (Real(2) * dot(normal, direction)) - direction;
}

/// The material's specular times a power of the cosine between the mirrored light and the eye.
///
/// @param power  called with 1 - cos, 0 or more; returns the power, 0 to 1
template <class Real, class Power>
[[nodiscard]] Real highlight_by(const Power& power, const PhongMaterial& material,
                                const LightSample<Real>& light, const Vec3<Real>& normal,
                                const Vec3<Real>& to_eye) {
  const Vec3<Real> mirrored = mirror(light.to_light, normal);
  const Vec3<Real> apart = mirrored - to_eye;
  const Real versine = dot(apart, apart) * Real(0.5);
  return Real(material.specular) *
         select(light.cosine > Real(0) && versine < Real(1), power(versine), Real(0));
}

/// Phong's highlight, specular cos^s with the shininess s; 0 in shadow and from 90 degrees on.
///
/// @param to_eye  unit vector from the hit point to the eye
/// @return        0 to specular
/// Textbook: max(0, r . e)^s. Here exp(s log1p(-|r - e|^2 / 2)): cos near 1 keeps its digits.
/// Source: Phong, "Illumination for Computer Generated Pictures" (1975); the lecture.
template <class Real>
[[nodiscard]] Real highlight(const PhongMaterial& material, const LightSample<Real>& light,
                             const Vec3<Real>& normal, const Vec3<Real>& to_eye) {
  const auto power = [&](const Real& versine) {
    return exp(Real(material.shininess) * log1p(-clamp(versine, Real(0), below_one<Real>())));
  };
  return highlight_by(power, material, light, normal, to_eye);
}

/// The highlight of the lecture's slides, specular (r . d)^s, d from the eye to the point.
/// Domain: even whole exponents; others give negative light or NaN, as chapter 06 shows.
template <class Real>
[[nodiscard]] Real highlight_of_the_slides(const PhongMaterial& material,
                                           const LightSample<Real>& light, const Vec3<Real>& normal,
                                           const Vec3<Real>& to_eye) {
  const Vec3<Real> mirrored = mirror(light.to_light, normal);
  const Real cosine = -dot(mirrored, to_eye);
  return Real(material.specular) * power(cosine, static_cast<Scalar<Real>>(material.shininess));
}

/// The highlight by the chosen formula; 0 for a material without one.
template <class Real>
[[nodiscard]] Real highlight(HighlightFormula formula, const PhongMaterial& material,
                             const LightSample<Real>& light, const Vec3<Real>& normal,
                             const Vec3<Real>& to_eye) {
  if (material.specular == 0) return Real(0);
  return formula == HighlightFormula::phong
             ? highlight(material, light, normal, to_eye)
             : highlight_of_the_slides(material, light, normal, to_eye);
}

}  // namespace texmap
