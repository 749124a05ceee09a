// Exercise 06.1: the mirrored direction
//
// A ray comes to a mirror in the direction d. n is the mirror's normal. Both have the length 1.
// Return the direction r in which the ray goes on: the same part along the surface as d has, and
// the opposite part along n.
#include "exercise.hpp"

Vec3 mirrored(Vec3 d, Vec3 n) {
  // solution
  return d - n * (2 * dot(n, d));
  // start: // Your line here. dot(n, d) is a number; n * 2.0 and n - d are vectors.
  // start: return n - d * 2.0;
}
// hint: The part of d along n is n * dot(n, d). The rest of d lies along the surface.
// hint: r is the rest minus the first part.
