// A texture on a surface, placed there by a mapping.
#pragma once
#include "math/color.hpp"
#include "scene/paint.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// A paint in two parts: a mapping from a direction to (u, v), a texture from (u, v) to a color.
/// To add a mapping, write a struct that maps a Vec3 to a Uv; a texture maps a Uv to a Color.
template <class Mapping, class Texture>
struct Mapped {
  Mapping mapping;
  Texture texture;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Hit<Real>& hit) const {
    static_assert(CallableWith<Mapping, Vec3<Real>>,
                  "a mapping cannot be called with a direction in this number: see AnyOf");
    const auto uv = mapping(hit.normal);
    static_assert(
        CallableWith<Texture, Uv<Real>>,
        "a texture cannot be called with (u, v) in this number: is its operator() const, "
        "and a template over the number? A lesson with textures in double alone says so in "
        "`about`: .numbers = Numbers::only_double");
    return texture(uv);
  }
};

}  // namespace texmap
