// Exercise 09.3: which level?
//
// Level 0 of a pyramid is the picture, and a texel of level l is 2^l texels of level 0 wide. A tap
// has to be `width` texels of level 0 wide. Let l be the whole level with 2^l <= width < 2^(l + 1).
// Then the part f of level l + 1 must be mixed in:
//     f = ((width / 2^l)^2 - 1) / 3
// Return l + f. No level is finer than 0: a width below 1 counts as 1.
#include "exercise.hpp"

double level_of_width(double width) {
  // solution
  double scaled = std::max(width, 1.0);
  int level = 0;
  while (scaled >= 2) {
    scaled = scaled / 2;
    level = level + 1;
  }
  return level + (scaled * scaled - 1) / 3;
  // start: // Your lines here. A while loop finds l.
  // start: // In C++, ^ is not a power: 2^l is std::pow(2, l).
  // start: return width < 2 ? 0 : 1;
}
// hint: Halve the width until it is below 2, and count how often. The count is l.
// hint: What is left after halving is width / 2^l, 1 to 2. Put it into the formula for f.
