// A texture for coordinates outside 0 to 1.
#pragma once
#include "math/color.hpp"
#include "texture/uv.hpp"
#include "texture/wrap.hpp"

namespace texmap {

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
