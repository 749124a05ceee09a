// Exercise 08.1: hit or miss?
//
// a, b and c are the corners of a triangle as the ray sees them: x and y are their places, and the
// ray is at (0, 0). z does not count. Return true if the ray goes through the triangle, also if it
// goes exactly through an edge. The corners may run counterclockwise or clockwise.
#include "exercise.hpp"

bool is_hit(Vec3 a, Vec3 b, Vec3 c) {
  // solution
  const double ab = a.x * b.y - a.y * b.x;
  const double bc = b.x * c.y - b.y * c.x;
  const double ca = c.x * a.y - c.y * a.x;
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
  // start: // Your lines here. a.x * b.y - a.y * b.x > 0: (0, 0) is left of the edge a to b.
  // start: return a.x * b.x < 0 && a.y * c.y < 0;
}
// hint: Go around: the edges are a to b, b to c, and c to a.
// hint: Counterclockwise: the ray is left of all three. Clockwise: right of all three.
// hint: On an edge the edge function is 0. Take >= and <=, or rays slip through.
