// Unsigned 32-bit integers, one for each lane of a number: what hashes and samplers compute with.
#pragma once
#include "number/number.hpp"

namespace texmap {

/// Unsigned 32-bit integers, one for each lane of Real: a plain std::uint32_t for plain numbers.
template <class Real>
using UInt = typename NumberTraits<Real>::UInt;

/// `yes` where a < b, else `no`.
[[nodiscard]] inline std::uint32_t select_less(std::uint32_t a, std::uint32_t b, std::uint32_t yes,
                                               std::uint32_t no) {
  return a < b ? yes : no;
}

/// The integer in lane `i` of `bits`.
template <class Real>
[[nodiscard]] inline std::uint32_t uint_lane(const UInt<Real>& bits, std::size_t i) {
  if constexpr (lanes<Real> == 1) {
    return bits;
  } else {
    return bits.get(i);
  }
}

/// Integers as numbers, exact. Domain: below 2^24, which float holds.
template <class Real>
[[nodiscard]] inline Real real_from_uint(const UInt<Real>& bits) {
  if constexpr (lanes<Real> == 1) {
    return static_cast<Real>(bits);
  } else {
    return bits.template to_real<Real>();
  }
}

/// The numbers of all lanes as integers, cut off. Domain: 0 to 2^31 - 1.
template <class Real>
[[nodiscard]] inline UInt<Real> uint_from_real(const Real& x) {
  if constexpr (lanes<Real> == 1) {
    return static_cast<std::uint32_t>(static_cast<int>(x));
  } else {
    return UInt<Real>::from_real(x);
  }
}

/// The upper 24 bits as a fraction in [0, 1), a multiple of 2^-24: the same in every Real.
template <class Real>
[[nodiscard]] inline Real unit_interval(const UInt<Real>& bits) {
  return real_from_uint<Real>(bits >> 8) * Real(0x1p-24F);
}

}  // namespace texmap
