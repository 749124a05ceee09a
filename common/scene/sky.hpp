// The light of rays that hit nothing.
#pragma once
#include "math/color.hpp"
#include "scene/ray.hpp"

namespace texmap {

/// A sky with a color that changes with the height of the ray's direction.
struct GradientSky {
  Rgb below;  ///< seen straight down
  Rgb above;  ///< seen straight up

  /// True if the sky is uniform: then a ray's direction does not matter.
  [[nodiscard]] bool is_constant() const {
    return below.r == above.r && below.g == above.g && below.b == above.b;
  }

  /// The light along a ray of unit length.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    if (is_constant()) return number_cast<Real>(below);
    const Real height = (ray.direction.y + Real(1)) * Real(0.5);
    return mix(number_cast<Real>(below), number_cast<Real>(above), height);
  }
};

}  // namespace texmap
