// Waves as textures: heights with a formula, in (u, v) and in space.
#pragma once
#include "math/circle.hpp"
#include "math/color.hpp"
#include "scene/hit.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// A product of sines in (u, v), -1 to 1: `across` waves from u = 0 to 1, `up` from v = 0 to 1.
struct UvWaves {
  double across = 24;
  double up = 12;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    return gray(on_circle(uv.u * Real(across)).sine * on_circle(uv.v * Real(up)).sine);
  }
};

/// A product of three cosines of the normal's coordinates, -1 to 1, `per_unit` waves a radius.
/// It needs no (u, v): no seam, no poles.
struct SolidWaves {
  double per_unit = 5;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Hit<Real>& hit) const {
    const auto wave = [&](const Real& x) { return on_circle(x * Real(per_unit)).cosine; };
    return gray(wave(hit.normal.x) * wave(hit.normal.y) * wave(hit.normal.z));
  }
};

}  // namespace texmap
