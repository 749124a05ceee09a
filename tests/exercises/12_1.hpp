// Exercise 12.1: light from four bytes
//
// A texel of a .hdr file has a byte for red, green and blue, and a byte for their common exponent.
// The light of a channel with the byte m and the exponent k is
//     (m + 1/2) 2^(k - 136),   but 0 for m = 0
// Return the light of the texel; k is at least 1. It can be far above 1: the sun.
#include "exercise.hpp"

Color light_of_texel(int red, int green, int blue, int exponent) {
  // solution
  const double step = std::exp2(exponent - 136);
  const auto light = [&](int byte) { return byte == 0 ? 0 : (byte + 0.5) * step; };
  return {light(red), light(green), light(blue)};
  // start: // Your lines here. std::exp2(x) is 2 to the power x.
  // start: return {red / 255.0, green / 255.0, blue / (exponent + 255.0)};
}
// hint: The power of 2 is the same for all three channels: compute it once.
// hint: (red + 0.5) * step, and 0 where red is 0; then the same for green and blue.
