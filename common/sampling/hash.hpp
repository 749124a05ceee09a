// Random numbers without a state: each is a hash of where it is used, so that no thread or lane order can change it.
#pragma once
#include "bits.hpp"

namespace texmap {

/// A hash of 32 bits: a permutation of all integers in which each input bit changes each output bit about half the time.
///
/// @param x  one integer, or one for each lane
/// @return   all 32 bits are equally good; 0 gives 0
/// Source: the two-round form of Wellons, "Prospecting for Hash Functions" (2018), with the constants found in issue 19 of his
/// program hash-prospector (2022), whose bias, 0.11, was the least known.
template <class Integers>
[[nodiscard]] inline Integers hash_bits(Integers x) {
  x = x ^ (x >> 16);
  x = x * 0x21f0aaadU;
  x = x ^ (x >> 15);
  x = x * 0xd35a2d97U;
  x = x ^ (x >> 15);
  return x;
}

/// The number under which the samplers know a pixel, one for each lane.
///
/// @param column, row  from 0; pixels of a picture up to 65536 wide and high all get different numbers
/// @return  hashed already: pictures of any size give a pixel the same number, and neighbours have nothing in common
template <class Real>
[[nodiscard]] inline Bits<Real> bits_of_pixels(const Bits<Real>& column, const Bits<Real>& row) {
  return hash_bits(Bits<Real>(column + ((row << 16) + 0x9e3779b9U)));
}

/// The same for `lanes` pixels of a row from `column` on.
template <class Real>
[[nodiscard]] inline Bits<Real> pixel_bits(std::uint32_t column, std::uint32_t row) {
  const auto columns = bits_from_lanes<Real>([column](std::size_t i) { return column + static_cast<std::uint32_t>(i); });
  return bits_of_pixels<Real>(columns, Bits<Real>(row));
}

}  // namespace texmap
