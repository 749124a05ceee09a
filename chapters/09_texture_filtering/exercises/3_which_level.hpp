// Exercise 09.3: which level?
//
// Three neighboring rays meet a globe: that of a pixel has the texture coordinates `here`, that of
// the next pixel to the right has `right`, and that of the next one down has `below`. The globe's
// picture has width x height texels and is laid around it once: after u = 1 it begins again.
// In the picture, how many texels is the way from `here` to each neighbor? Return the level, in
// general not a whole number, whose texels are as wide as the longer one. A texel of level l is
// 2^l texels of level 0 wide. No level is finer than 0. Neighbors are less than half a turn apart.
//
// Check it:  ./course check 09.3
#include "exercise.hpp"

double level_for(Uv here, Uv right, Uv below, int width, int height) {
  // Your lines here. std::log2(x) is the number l with 2^l = x.
  return here.u * width;
}
