// Exercise 06.3: the blend
//
// Blend the texture's color with the light, a gray: the texture has the share t, the light has the
// rest. The light is 0 or more, and counts as 1 where it is more than 1.
//
// Check it:  ./course check 06.3
#include "exercise.hpp"

Color blended(Color texture, double light, double t) {
  // Your lines here. You can add colors, and multiply a color by a number.
  return texture * (light * t);
}
