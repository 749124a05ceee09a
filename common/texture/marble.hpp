// Marble: a solid texture, which needs no (u, v), and the paint that looks up a solid texture.
#pragma once
#include "math/color.hpp"
#include "scene/hit.hpp"
#include "texture/noise.hpp"

namespace texmap {

/// Veins in a stone: planes at equal distances along x, bent by noise.
struct Marble {
  Rgb stone{0.9, 0.9, 0.9};
  Rgb vein{0.25, 0.3, 0.4};
  double veins = 1.5;  ///< in a length of 1
  double bend = 2;     ///< how far noise moves a vein, in distances between veins; 0 for planes

  /// The color at a point.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Vec3<Real>& p) const {
    const Real across = p.x * Real(veins) + Real(bend) * fractal_noise(p * Real(veins), 5);
    const Real from_middle = abs(across - floor(across) - Real(0.5)) * Real(2);  // 1 in a vein
    return mix(number_cast<Real>(stone), number_cast<Real>(vein), square(smooth_step(from_middle)));
  }
};

/// A paint in one part: a solid texture maps the point of a hit to a color. SolidCheckerboard and
/// Marble are such textures.
template <class Texture>
struct InSpace {
  Texture texture;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Hit<Real>& hit) const {
    return texture(hit.point);
  }
};

}  // namespace texmap
