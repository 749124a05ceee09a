// What a ray sees that hits nothing.
#pragma once
#include "color.hpp"
#include "ray.hpp"

namespace texmap {

/// A sky that fades with the height of the line of sight.
struct GradientSky {
  Rgb below;  ///< seen straight down
  Rgb above;  ///< seen straight up

  /// True if it looks alike everywhere: then nobody need ask where a ray goes.
  [[nodiscard]] bool is_constant() const { return below.r == above.r && below.g == above.g && below.b == above.b; }

  /// The light seen along a ray; as GradientSkyIn's.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const;
};

/// The same sky made ready for the number that a picture is drawn with.
template <class Real>
struct GradientSkyIn {
  Color<Real> below;
  Color<Real> above;
  bool constant;

  [[nodiscard]] bool is_constant() const { return constant; }

  /// The light seen along a ray.
  ///
  /// @param ray  with a direction of unit length; not looked at where the sky is constant
  /// Bound: 2 unit roundoffs of 1, for colors of 0 to 1; docs/numbers.md.
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    if (constant) return below;
    const Real height = (ray.direction.y + Real(1)) * Real(0.5);
    return mix(below, above, height);
  }
};

/// A sky in another number, for those who look at it often.
template <class Real>
[[nodiscard]] GradientSkyIn<Real> number_cast(const GradientSky& sky) {
  return {number_cast<Real>(sky.below), number_cast<Real>(sky.above), sky.is_constant()};
}

template <class Real>
[[nodiscard]] Color<Real> GradientSky::operator()(const Ray<Real>& ray) const {
  return number_cast<Real>(*this)(ray);
}

}  // namespace texmap
