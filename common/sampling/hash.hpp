// Random numbers without a state: each is a hash of where it is used.
#pragma once
#include "number/uint.hpp"

namespace texmap {

/// A hash of 32 bits, a permutation in which each input bit changes each output bit half the time.
///
/// @param x  an integer, or one for each lane; 0 gives 0
/// Source: Wellons, "Prospecting for Hash Functions" (2018); hash-prospector, issue 19.
template <class Integers>
[[nodiscard]] inline Integers hash_bits(Integers x) {
  x = x ^ (x >> 16);
  x = x * 0x21f0aaadU;
  x = x ^ (x >> 15);
  x = x * 0xd35a2d97U;
  x = x ^ (x >> 15);
  return x;
}

/// A pixel's hash, the `pixel` of the samplers; the same in pictures of any size.
///
/// @param column, row  from 0; different for all pixels of pictures up to 65536 x 65536
template <class Real>
[[nodiscard]] inline UInt<Real> hash_pixels(const UInt<Real>& column, const UInt<Real>& row) {
  return hash_bits(UInt<Real>(column + ((row << 16) + 0x9e3779b9U)));
}

}  // namespace texmap
