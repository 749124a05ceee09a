// Coordinates at the limits of a number.
#pragma once
#include <limits>
#include <vector>

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

}  // namespace texmap::test
