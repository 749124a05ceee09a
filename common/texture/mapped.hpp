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
    // A copy: a mapping that is a function of its own would want the whole hit in memory, asked for or not.
    const Vec3<Real> normal = hit.normal;
    return texture(mapping(normal));
  }
};

}  // namespace texmap
