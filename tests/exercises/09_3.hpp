// Exercise 09.3: which level?
//
// Three neighboring rays meet a globe: that of a pixel has the texture coordinates `here`, that of
// the next pixel to the right has `right`, and that of the next one down has `below`. The globe's
// picture has width x height texels and is laid around it once: after u = 1 it begins again.
// In the picture, how many texels is the way from `here` to each neighbor? Return the level, in
// general not a whole number, whose texels are as wide as the longer one. A texel of level l is
// 2^l texels of level 0 wide. No level is finer than 0. Neighbors are less than half a turn apart.
#include "exercise.hpp"

double level_for(Uv here, Uv right, Uv below, int width, int height) {
  // solution
  double longest = 1;
  for (const Uv next : {right, below}) {
    double across = std::abs(next.u - here.u);
    across = std::min(across, 1 - across);
    longest = std::max(longest, std::hypot(across * width, (next.v - here.v) * height));
  }
  return std::log2(longest);
  // start: // Your lines here. std::log2(x) is the number l with 2^l = x.
  // start: return here.u * width;
}
// hint: The way is a vector: (difference of u * width, difference of v * height). Its length?
// hint: From u = 0.99 to 0.01 it is not 0.98 of a turn but 0.02, across the seam.
// hint: 2^l is the length for l = std::log2(length). A length below 1 counts as 1.
