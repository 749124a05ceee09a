// Exercise 13.1: the cheapest way
//
// `ways` were measured with a texture 2048 texels wide: the milliseconds of a picture, ms, and how
// far off a place is, in texels of that texture, `seen` and `at_most`. Your texture is `width`
// texels wide. A place may be off by `budget` of its texels, and no more. Return the number of the
// way to take, counted from 0: the fastest one that is sure to keep to the budget. Of several that
// are as fast take the most accurate one. If no way is sure to keep to it, return -1.
//
// Check it:  ./course check 13.1
#include "exercise.hpp"

int cheapest(const std::vector<Way>& ways, int width, double budget) {
  // Your lines here. ways.size() is how many there are, and ways[0].ms is a time.
  return static_cast<int>(ways.size()) / 2;
}
