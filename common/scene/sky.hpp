// The light of rays that hit nothing.
#pragma once
#include "math/color.hpp"
#include "scene/ray.hpp"

namespace texmap {

/// A sky with a color that changes with the height of the ray's direction.
template <class Real = double>
struct GradientSky {
  Color<Real> below;  ///< seen straight down
  Color<Real> above;  ///< seen straight up

  /// True if the sky is uniform: then a ray's direction does not matter.
  [[nodiscard]] bool is_constant() const {
    return below.r == above.r && below.g == above.g && below.b == above.b;
  }

  /// The light along a ray of unit length. Bound: 2 unit roundoffs of 1, for colors of 0 to 1.
  template <class Other>
  [[nodiscard]] Color<Other> operator()(const Ray<Other>& ray) const {
    if (is_constant()) return number_cast<Other>(below);
    const Other height = (ray.direction.y + Other(1)) * Other(0.5);
    return mix(number_cast<Other>(below), number_cast<Other>(above), height);
  }
};

}  // namespace texmap
