// Phong's highlight.
#pragma once
#include "color.hpp"
#include "light.hpp"

namespace texmap {

/// A matt surface with a gloss on it.
struct Finish {
  Matt matt;
  double specular = 0;    ///< strength of the highlight, 0 to 1
  double shininess = 50;  ///< Phong's exponent, 0 to 1e30: the larger, the smaller the highlight
};

/// An object of a scene with a finish of its own.
template <class Paint>
struct Glossy {
  Sphere sphere;
  Paint paint;
  Finish finish{};
};

/// Whose formula gives the highlight.
enum class HighlightFormula {
  phong,    ///< towards the eye, and only where the lamp shines
  lecture,  ///< as seed 4's slides have it: away from the eye, wherever that happens to be positive
};

/// How bright the mirror image of the lamp is: the finish's specular times a power of the cosine of the angle between the
/// mirrored light and the direction to the eye.
///
/// @param power  called with the versine, 1 - cos, 0 or more; gives 0 to 1. `highlight` has the formula, PowerKernels are
/// faster
template <class Real, class Power>
[[nodiscard]] Real highlight_by(const Power& power, const Finish& finish, const Illumination<Real>& lamp,
                                const Vec3<Real>& normal, const Vec3<Real>& to_eye) {
  const Vec3<Real> mirrored = normal * (Real(2) * dot(normal, lamp.to_light)) - lamp.to_light;
  const Vec3<Real> apart = mirrored - to_eye;
  const Real versine = dot(apart, apart) * Real(0.5);
  return Real(finish.specular) * select(lamp.cosine > Real(0) && versine < Real(1), power(versine), Real(0));
}

/// Phong's highlight: specular times cos^shininess; see highlight_by.
///
/// @param to_eye  unit vector from the hit point to the eye
/// @return  0 to specular; 0 where the lamp is hidden or behind the surface, and where the directions are 90 degrees apart or
/// more The power is taken as exp(n log1p(-|r - e|^2 / 2)), because cos = 1 - |r - e|^2 / 2: a cosine near 1 has lost the
/// digits that say how far from 1 it is, and the power multiplies what is lost by n. Any exponent gives a number: within 6 u
/// sqrt(1 + n) where the cosine is above 0.1, in [0, specular] everywhere; docs/numbers.md. Source: Phong, "Illumination for
/// Computer Generated Pictures" (1975); seed 4 with the sign of the eye's direction mended.
template <class Real>
[[nodiscard]] Real highlight(const Finish& finish, const Illumination<Real>& lamp, const Vec3<Real>& normal,
                             const Vec3<Real>& to_eye) {
  const auto power = [&](const Real& versine) {
    return exp(Real(finish.shininess) * log1p(-clamp(versine, Real(0), below_one<Real>())));
  };
  return highlight_by(power, finish, lamp, normal, to_eye);
}

/// Seed 4's highlight as its slides have it: specular (r . d)^shininess with d from the eye to the surface, the wrong way
/// round. Domain: an even whole exponent; others give negative light or NaN, which is the point of showing it.
template <class Real>
[[nodiscard]] Real highlight_of_the_slides(const Finish& finish, const Illumination<Real>& lamp, const Vec3<Real>& normal,
                                           const Vec3<Real>& to_eye) {
  const Vec3<Real> mirrored = normal * (Real(2) * dot(normal, lamp.to_light)) - lamp.to_light;
  const Real cosine = -dot(mirrored, to_eye);
  return Real(finish.specular) * power(cosine, static_cast<Scalar<Real>>(finish.shininess));
}

/// The highlight by the formula of that name; 0 without any formula for a finish that has no gloss.
template <class Real>
[[nodiscard]] Real highlight(HighlightFormula formula, const Finish& finish, const Illumination<Real>& lamp,
                             const Vec3<Real>& normal, const Vec3<Real>& to_eye) {
  if (finish.specular == 0) return Real(0);
  return formula == HighlightFormula::phong ? highlight(finish, lamp, normal, to_eye)
                                            : highlight_of_the_slides(finish, lamp, normal, to_eye);
}

}  // namespace texmap
