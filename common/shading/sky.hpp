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

  /// The light seen along a ray.
  ///
  /// @param ray  with a direction of unit length; not looked at where the sky is constant
  /// Bound: 2 unit roundoffs of 1, for colors of 0 to 1; docs/numbers.md.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    if (is_constant()) return number_cast<Real>(below);
    const Real height = (ray.direction.y + Real(1)) * Real(0.5);
    return mix(number_cast<Real>(below), number_cast<Real>(above), height);
  }
};

}  // namespace texmap
