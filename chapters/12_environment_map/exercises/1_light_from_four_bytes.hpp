// Exercise 12.1: light from four bytes
//
// A texel of a .hdr file has a byte for red, green and blue, and a byte for their common exponent.
// The light of a channel with the byte m and the exponent k is
//     (m + 1/2) 2^(k - 136),   but 0 for m = 0
// Return the light of the texel; k is at least 1. It can be far above 1: the sun.
//
// Check it:  ./course check 12.1
#include "exercise.hpp"

Color light_of_texel(int red, int green, int blue, int exponent) {
  // Your lines here. std::exp2(x) is 2 to the power x.
  return {red / 255.0, green / 255.0, blue / (exponent + 255.0)};
}
