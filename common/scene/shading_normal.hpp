// Light on a surface that is shaded with another normal than its own.
#pragma once
#include "scene/light.hpp"

namespace texmap {

/// A factor, 0 to 1, that lets light fade where it comes from below the true horizon.
///
/// @param true_cosine, shading_cosine  to the light, of the surface's and of the shading normal
/// @param between                      the cosine between the two normals
/// @return  exactly 1 where both normals are the same; 0 where the surface faces away
/// Source: Chiang, Li and Burley, "Taming the Shadow Terminator" (2019).
template <class Real>
[[nodiscard]] Real terminator(const Real& true_cosine, const Real& shading_cosine,
                              const Real& between) {
  const Real divisor = shading_cosine * between;
  const Mask<Real> usual = divisor > Real(0);
  const Real ratio = clamp(true_cosine / select(usual, divisor, Real(1)), Real(0), Real(1));
  // Textbook: -ratio^3 + ratio^2 + ratio. This form is exactly 1 also for 1 - a rounding.
  const Real fade = Real(1) - square(Real(1) - ratio) * (Real(1) + ratio);
  return select(usual, fade, Real(0));
}

/// The light `plain` of a surface, shaded with the unit normal `shading`. Whether light arrives is
/// decided by the surface itself: a bump cannot catch light that its globe hides.
template <class Real>
[[nodiscard]] LightSample<Real> shaded(const LightSample<Real>& plain, const Hit<Real>& hit,
                                       const Vec3<Real>& shading) {
  const Real cosine = max(dot(shading, plain.to_light), Real(0));
  return {plain.to_light, cosine * terminator(plain.cosine, cosine, dot(shading, hit.normal))};
}

/// sample_light for such a surface.
template <class Real, class Objects>
[[nodiscard]] LightSample<Real> sample_light(const PointLight& light, const Objects& objects,
                                             const Hit<Real>& hit, const Vec3<Real>& shading) {
  return shaded(sample_light(light, objects, hit), hit, shading);
}

}  // namespace texmap
