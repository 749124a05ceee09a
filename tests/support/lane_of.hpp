// One lane of packs, and of vectors, colors, places and rays of packs.
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

/// One lane of a pack, or of what is made of packs.
template <class Real>
[[nodiscard]] Scalar<Real> lane_of(const Real& x, std::size_t i) {
  return lane(x, i);
}
template <class Real>
[[nodiscard]] Vec3<Scalar<Real>> lane_of(const Vec3<Real>& p, std::size_t i) {
  return {lane(p.x, i), lane(p.y, i), lane(p.z, i)};
}
template <class Real>
[[nodiscard]] Color<Scalar<Real>> lane_of(const Color<Real>& c, std::size_t i) {
  return {lane(c.r, i), lane(c.g, i), lane(c.b, i)};
}
template <class Real>
[[nodiscard]] Uv<Scalar<Real>> lane_of(const Uv<Real>& uv, std::size_t i) {
  return {lane(uv.u, i), lane(uv.v, i)};
}
template <class Real>
[[nodiscard]] Ray<Scalar<Real>> lane_of(const Ray<Real>& ray, std::size_t i) {
  return {lane_of(ray.origin, i), lane_of(ray.direction, i)};
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
