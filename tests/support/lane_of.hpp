// One lane of packs, and of vectors, colors, places, rays, arrays and tuples of packs.
#pragma once
#include <array>
#include <cstddef>
#include <tuple>

#include "math/color.hpp"
#include "math/vec3.hpp"
#include "number/number.hpp"
#include "scene/ray.hpp"
#include "texture/uv.hpp"

namespace texmap::test {

/// What a thing of several numbers is made of. To add one, list its members as its braces do.
template <class Real>
[[nodiscard]] auto parts_of(const Vec3<Real>& p) {
  return std::tie(p.x, p.y, p.z);
}
template <class Real>
[[nodiscard]] auto parts_of(const Color<Real>& c) {
  return std::tie(c.r, c.g, c.b);
}
template <class Real>
[[nodiscard]] auto parts_of(const Uv<Real>& uv) {
  return std::tie(uv.u, uv.v);
}
template <class Real>
[[nodiscard]] auto parts_of(const Ray<Real>& ray) {
  return std::tie(ray.origin, ray.direction);
}
template <class Thing>
concept HasParts = requires(const Thing& thing) {
  parts_of(thing);
};

/// One lane of a pack, or of what is made of packs.
template <class Real>
[[nodiscard]] Scalar<Real> lane_of(const Real& x, std::size_t i) {
  return lane(x, i);
}
template <template <class> class Thing, class Real>
requires HasParts<Thing<Real>>
[[nodiscard]] Thing<Scalar<Real>> lane_of(const Thing<Real>& thing, std::size_t i) {
  return std::apply([i](const auto&... part) { return Thing<Scalar<Real>>{lane_of(part, i)...}; },
                    parts_of(thing));
}
template <class Real, std::size_t count>
[[nodiscard]] std::array<Scalar<Real>, count> lane_of(const std::array<Real, count>& all,
                                                      std::size_t i) {
  std::array<Scalar<Real>, count> one;
  for (std::size_t k = 0; k < count; ++k) one[k] = lane(all[k], i);
  return one;
}
template <class... Parts>
[[nodiscard]] auto lane_of(const std::tuple<Parts...>& parts, std::size_t i) {
  return std::apply([i](const auto&... part) { return std::tuple(lane_of(part, i)...); }, parts);
}

}  // namespace texmap::test
