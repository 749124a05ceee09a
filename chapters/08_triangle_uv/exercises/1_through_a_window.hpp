// Exercise 08.1: through a window?
//
// A flat window has any number of corners, three or more, and bulges outward everywhere. `corners`
// are in their order around it, counterclockwise or clockwise, as the ray sees them: x and y are
// their places, and the ray is at (0, 0). z does not count. Return true if the ray goes through the
// window, also if it goes exactly through an edge or a corner. A window that the ray sees exactly
// from the side has no area: all of it is on one line, and no ray goes through it.
//
// Check it:  ./course check 08.1
#include "exercise.hpp"

bool is_hit(const std::vector<Vec3>& corners) {
  // Your lines here. a.x * b.y - a.y * b.x > 0: (0, 0) is left of the edge a to b.
  return corners[0].x * corners[1].x < 0;
}
