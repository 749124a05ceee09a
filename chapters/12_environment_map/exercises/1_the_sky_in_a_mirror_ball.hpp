// Exercise 12.1: the sky in a mirror ball
//
// A camera photographs a mirror ball from so far away that all of its rays run along -z. The ball's
// outline touches the four sides of the picture. u is 0 at the left side and 1 at the right one,
// v is 0 at the lower side and 1 at the upper one; +x is to the right and +y is up. Return the
// direction of the sky that is seen at (u, v), of length 1. The place is inside the outline.
//
// Check it:  ./course check 12.1
#include "exercise.hpp"

Vec3 mirrored_sky(Uv uv) {
  // Your lines here.
  return normalize(Vec3{uv.u, uv.v, 1});
}
