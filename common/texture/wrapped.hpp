// A texture for coordinates outside 0 to 1.
#pragma once
#include "math/color.hpp"
#include "texture/uv.hpp"
#include "texture/wrap.hpp"

namespace texmap {

/// A coordinate moved into [0, 1] as `wrap` says: the image again, mirrored, or its edge.
///
/// @param x  any number; NaN gives 0
/// Bound: one rounding of x. Domain of `wrap`: repeat, mirror and clamp.
template <class Real>
[[nodiscard]] Real wrapped_coordinate(Wrap wrap, const Real& x) {
  if (wrap == Wrap::repeat) return clamp_u(x - floor(x));
  if (wrap == Wrap::mirror) {
    const Real in_two = x - Real(2) * floor(x * Real(0.5));  // 0 to 2: the image and its mirror
    return clamp(min(in_two, Real(2) - in_two), Real(0), Real(1));
  }
  return clamp(x, Real(0), Real(1));
}

/// A texture that goes on beyond its edges.
template <class Texture>
struct Wrapped {
  Wrap wrap = Wrap::repeat;
  Texture texture;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    return texture(Uv<Real>{wrapped_coordinate(wrap, uv.u), wrapped_coordinate(wrap, uv.v)});
  }
};

}  // namespace texmap
