// Exercise 06.1: the mirrored direction
//
// A ray comes to a mirror in the direction d. n is the mirror's normal. Both have the length 1.
// Return the direction r in which the ray goes on: the same part along the surface as d has, and
// the opposite part along n.
//
// Check it:  ./course check 06.1
#include "exercise.hpp"

Vec3 mirrored(Vec3 d, Vec3 n) {
  // Your line here. dot(n, d) is a number; n * 2.0 and n - d are vectors.
  return n - d * 2.0;
}
