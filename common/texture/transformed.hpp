// A mapping whose (u, v) are scaled, turned and moved.
#pragma once
#include <optional>
#include <type_traits>

#include "math/circle.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// Other places to read a texture at: (u, v) scaled, then turned about (0, 0), from the u axis
/// towards the v axis, then moved. On the surface the picture does the opposite: twice the u shows
/// it twice, half as wide; a larger u moves it towards smaller u; a turn turns it back.
/// Source: glTF, KHR_texture_transform, which has the same order.
struct UvTransform {
  Uv<double> scale{1, 1};
  OnCircle<double> turn{1, 0};
  Uv<double> offset{0, 0};

  /// Bound: 6 unit roundoffs of the sum of |scale.u u|, |scale.v v| and the offset.
  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const Uv<Real>& uv) const {
    const Real u = uv.u * Real(scale.u);
    const Real v = uv.v * Real(scale.v);
    const Real c = Real(turn.cosine);
    const Real s = Real(turn.sine);
    return {u * c - v * s + Real(offset.u), u * s + v * c + Real(offset.v)};
  }
};

/// A mapping, and a transform of its (u, v); they may then lie outside 0 to 1: see wrapped.hpp.
template <class Mapping>
struct Transformed {
  std::optional<UvTransform> transform;  ///< nothing: (u, v) stay as they are
  Mapping mapping;

  template <class Place>
  requires std::is_invocable_v<const Mapping&, const Place&>
  [[nodiscard]] auto operator()(const Place& place) const {
    const auto uv = mapping(place);
    return transform ? (*transform)(uv) : uv;
  }
};

}  // namespace texmap
