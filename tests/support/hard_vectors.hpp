// Vectors with coordinates at the limits of a number, and the law that a mapping gives each a place
// on a texture.
#pragma once
#include <doctest.h>

#include <limits>
#include <vector>

#include "texture/uv.hpp"

namespace texmap::test {

/// Zeros, ones, the smallest and the largest numbers, with either sign, and a few between.
template <class Real>
[[nodiscard]] std::vector<Real> hard_finite_numbers() {
  using Limits = std::numeric_limits<Real>;
  std::vector<Real> all = {Limits::epsilon(), Real(1e-30), Real(-1e30)};
  for (const Real size : {Real(0), Real(1), Limits::denorm_min(), Limits::min(), Limits::max()}) {
    all.push_back(size);
    all.push_back(-size);
  }
  return all;
}

/// Checks that `mapping` gives u in [0, 1) and v in [0, 1] for every vector of such coordinates.
template <class Real, class Mapping>
void check_every_place(const Mapping& mapping, const std::vector<Real>& coordinates) {
  for (const Real x : coordinates) {
    for (const Real y : coordinates) {
      for (const Real z : coordinates) {
        const Uv<Real> uv = mapping(Vec3<Real>{x, y, z});
        CAPTURE(x);
        CAPTURE(y);
        CAPTURE(z);
        REQUIRE(uv.u >= Real(0));
        REQUIRE(uv.u < Real(1));
        REQUIRE(uv.v >= Real(0));
        REQUIRE(uv.v <= Real(1));
      }
    }
  }
}

}  // namespace texmap::test
