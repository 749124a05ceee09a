// A texture laid on a surface by a mapping.
#pragma once
#include "color.hpp"
#include "sphere.hpp"
#include "uv.hpp"

namespace texmap {

/// A paint in two parts: a mapping from a direction to (u, v), and a texture from (u, v) to a color.
/// The (u, v) is computed here and nowhere else, so a surface whose paint does not ask for it never pays for it.
template <class Mapping, class Texture>
struct Mapped {
  Mapping mapping;
  Texture texture;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Hit<Real>& hit) const {
    return texture(mapping(hit.normal));
  }
};

}  // namespace texmap
