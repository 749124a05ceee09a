// Texels and pixels as whole numbers, for tests that go through all of them.
#pragma once
#include "sampling/hash.hpp"
#include "texture/texel.hpp"

namespace texmap::test {

/// texel_number as a Real.
template <class Real>
[[nodiscard]] Real texel_index(const Real& u, int n,
                               TexelRounding rounding = TexelRounding::floor) {
  return static_cast<Real>(texel_number(u, n, rounding));
}

/// The same for the pixels of a row, one a lane, from `column` on.
template <class Real>
[[nodiscard]] inline UInt<Real> hash_row(std::uint32_t column, std::uint32_t row) {
  const auto columns = from_lanes<Real>([column](std::size_t i) {
    return static_cast<Scalar<Real>>(column + static_cast<std::uint32_t>(i));
  });
  return hash_pixels<Real>(uint_from_real(columns), UInt<Real>(row));
}

}  // namespace texmap::test
