// Exercise 08.1: hit or miss?
//
// a, b and c are the corners of a triangle as the ray sees them: x and y are their places, and the
// ray is at (0, 0). z does not count. Return true if the ray goes through the triangle, also if it
// goes exactly through an edge. The corners may run counterclockwise or clockwise.
//
// Check it:  ./course check 08.1
#include "exercise.hpp"

bool is_hit(Vec3 a, Vec3 b, Vec3 c) {
  // Your lines here. a.x * b.y - a.y * b.x > 0: (0, 0) is left of the edge a to b.
  return a.x * b.x < 0 && a.y * c.y < 0;
}
