// A texture on a surface, placed there by a mapping.
#pragma once
#include "math/color.hpp"
#include "scene/paint.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// (u, v) at a hit, by a mapping of hits or, where the direction is enough, of normals.
template <class Mapping, class AnyHit>
[[nodiscard]] auto uv_at(const Mapping& mapping, const AnyHit& hit) {
  constexpr bool takes_hit = requires { mapping(hit); };
  constexpr bool on_normal = requires { mapping(hit.normal); };
  static_assert(takes_hit || on_normal,
                "a mapping takes a Hit<Real> or its normal, a Vec3<Real>: is it const? See AnyOf");
  if constexpr (takes_hit) {
    return mapping(hit);
  } else {
    return mapping(hit.normal);
  }
}

/// A paint in two parts: a mapping to (u, v), a texture from (u, v) to a color.
/// To add one, map a direction (Vec3) or a whole Hit to a Uv; for a texture, map a Uv to a Color.
template <class Mapping, class Texture>
struct Mapped {
  Mapping mapping;
  Texture texture;

  template <template <class> class AnyHit, class Real>
  [[nodiscard]] Color<Real> operator()(const AnyHit<Real>& hit) const {
    const auto uv = uv_at(mapping, hit);
    static_assert(std::is_same_v<decltype(uv), const Uv<Real>>, "a mapping returns a Uv<Real>");
    static_assert(
        Gives<Texture, decltype(uv), Color<Real>>,
        "a texture cannot be called with (u, v) in this number, or returns no Color<Real> such as "
        "gray(x): is its operator() const, and a template over the number? With double alone, say "
        "in `about`: .numbers = Numbers::only_double");
    return texture(uv);
  }
};

}  // namespace texmap
