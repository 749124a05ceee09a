// The value of a fitted polynomial.
#pragma once
#include "engine/fast/coefficients.hpp"
#include "number/number.hpp"

namespace texmap {

/// The polynomial of a fit at `x`, its coefficients rounded to Real.
/// Even and odd powers are summed separately by Horner's rule: two short chains of operations.
template <class Fit, class Real>
[[nodiscard]] Real polynomial(const Real& x) {
  constexpr std::size_t terms = Fit::powers.size();
  const auto power = [](std::size_t k) { return Real(static_cast<Scalar<Real>>(Fit::powers[k])); };
  constexpr std::size_t top = terms - 1;
  const Real square = x * x;
  Real with_top = power(top);
  for (std::size_t k = top; k >= 2; k -= 2) with_top = with_top * square + power(k - 2);
  Real others = power(top - 1);
  for (std::size_t k = top - 1; k >= 2; k -= 2) others = others * square + power(k - 2);
  return top % 2 == 0 ? with_top + others * x : others + with_top * x;
}

}  // namespace texmap
