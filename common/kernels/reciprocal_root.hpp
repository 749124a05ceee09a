// One over the square root.
#pragma once
#include "number.hpp"

namespace texmap {

/// `guess`, which is near 1 / sqrt(x), after one of Newton's steps: a relative error e becomes 3/2 e^2, plus 2 epsilons of
/// rounding.
template <class Real>
[[nodiscard]] Real refine_reciprocal_root(const Real& x, const Real& guess) {
  const Real half = Real(0.5) * x * guess;
  return guess * (Real(1.5) - half * guess);
}

/// 1 / sqrt(x), by a root and a division: the same number on every machine.
///
/// @param x  above 0
/// Worst relative error: 3/4 epsilon, for every type and pack.
/// Machines have faster estimates with 11 to 14 bits, which `refine_reciprocal_root` makes good for float. But each maker's
/// estimate differs from the others', so that pictures would differ from machine to machine.
template <class Real>
[[nodiscard]] Real reciprocal_root(const Real& x) {
  return Real(1) / sqrt(x);
}

}  // namespace texmap
