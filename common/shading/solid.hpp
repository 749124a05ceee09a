// The plainest paint: one color everywhere.
#pragma once
#include "color.hpp"
#include "sphere.hpp"

namespace texmap {

/// One color all over. It asks nothing of the hit, so nothing is computed for it.
struct Solid {
  Rgb color;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Hit<Real>&) const {
    return number_cast<Real>(color);
  }
};

}  // namespace texmap
