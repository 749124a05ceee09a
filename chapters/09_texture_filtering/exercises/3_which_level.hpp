// Exercise 09.3: which level?
//
// Level 0 of a pyramid is the picture, and a texel of level l is 2^l texels of level 0 wide. A tap
// has to be `width` texels of level 0 wide. Let l be the whole level with 2^l <= width < 2^(l + 1).
// Then the part f of level l + 1 must be mixed in:
//     f = ((width / 2^l)^2 - 1) / 3
// Return l + f. No level is finer than 0: a width below 1 counts as 1.
//
// Check it:  ./course check 09.3
#include "exercise.hpp"

double level_of_width(double width) {
  // Your lines here. A while loop finds l.
  // In C++, ^ is not a power: 2^l is std::pow(2, l).
  return width < 2 ? 0 : 1;
}
