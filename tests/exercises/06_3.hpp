// Exercise 06.3: the blend
//
// Blend the texture's color with the light, a gray: the texture has the share t, the light has the
// rest. The light is 0 or more, and counts as 1 where it is more than 1.
#include "exercise.hpp"

Color blended(Color texture, double light, double t) {
  // solution
  const double gray = std::min(light, 1.0);
  return texture * t + Color{gray, gray, gray} * (1 - t);
  // start: // Your lines here. You can add colors, and multiply a color by a number.
  // start: return texture * (light * t);
}
// hint: A gray is a color with three equal parts: Color{x, x, x}.
// hint: The shares of both are t and 1 - t. At t = 1 only the texture is left.
