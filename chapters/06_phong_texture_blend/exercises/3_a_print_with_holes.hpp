// Exercise 06.3: a print with holes
//
// The map is printed on a gray ball. Where it is black, ink covers the ball: the texture has the
// share t. Where it is white, there is no ink: the texture has the share 0. In between, the share
// falls evenly with the brightness of the texture, the mean of its red, green and blue. The light,
// a gray, has the rest. It is 0 or more, and counts as 1 where it is more than 1.
// Return the color that one sees.
//
// Check it:  ./course check 06.3
#include "exercise.hpp"

Color printed(Color texture, double light, double t) {
  // Your lines here. You can add colors, and multiply a color by a number.
  return texture * (light * t);
}
