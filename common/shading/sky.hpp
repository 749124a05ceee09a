// What a ray sees that hits nothing.
#pragma once
#include "color.hpp"
#include "ray.hpp"

namespace texmap {

/// A sky that fades with the height of the line of sight.
struct GradientSky {
  Rgb below;  ///< seen straight down
  Rgb above;  ///< seen straight up

  /// @param ray  with a direction of unit length
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    const Real height = (ray.direction.y + Real(1)) * Real(0.5);
    return number_cast<Real>(below) * (Real(1) - height) + number_cast<Real>(above) * height;
  }
};

}  // namespace texmap
