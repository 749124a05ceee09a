// Exercise 08.1: through a window?
//
// A flat window has any number of corners, three or more, and bulges outward everywhere. `corners`
// are in their order around it, counterclockwise or clockwise, as the ray sees them: x and y are
// their places, and the ray is at (0, 0). z does not count. Return true if the ray goes through the
// window, also if it goes exactly through an edge or a corner. A window that the ray sees exactly
// from the side has no area: all of it is on one line, and no ray goes through it.
#include "exercise.hpp"

bool is_hit(const std::vector<Vec3>& corners) {
  // solution
  bool left = false, right = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 a = corners[i], b = corners[(i + 1) % corners.size()];
    const double side = a.x * b.y - a.y * b.x;
    left = left || side > 0;
    right = right || side < 0;
  }
  return left != right;
  // start: // Your lines here. a.x * b.y - a.y * b.x > 0: (0, 0) is left of the edge a to b.
  // start: return corners[0].x * corners[1].x < 0;
}
// hint: Go around: after the last corner comes the first one. % corners.size() helps.
// hint: Is the ray left of an edge, and is it right of one? A window that is hit has only one.
// hint: On an edge and on its line the edge function is 0. Without an area it can be 0 everywhere.
