// Exercise 06.3: a print with holes
//
// The map is printed on a gray ball. Where it is black, ink covers the ball: the texture has the
// share t. Where it is white, there is no ink: the texture has the share 0. In between, the share
// falls evenly with the brightness of the texture, the mean of its red, green and blue. The light,
// a gray, has the rest. It is 0 or more, and counts as 1 where it is more than 1.
// Return the color that one sees.
#include "exercise.hpp"

Color printed(Color texture, double light, double t) {
  // solution
  const double brightness = (texture.r + texture.g + texture.b) / 3;
  const double share = t * (1 - brightness);
  const double gray = std::min(light, 1.0);
  return texture * share + Color{gray, gray, gray} * (1 - share);
  // start: // Your lines here. You can add colors, and multiply a color by a number.
  // start: return texture * (light * t);
}
// hint: Which share has the texture where its brightness is 0, 1 and 1/2?
// hint: A gray is a color with three equal parts: Color{x, x, x}. It has the rest, 1 - share.
