// Exercise 06.1: the mirrored direction
//
// n is the normal of a surface, and l the direction to the lamp. Both have the length 1. Return the
// direction r in which a mirror would send the lamp's light: the same part along n as l has, and
// the opposite part along the surface.
#include "exercise.hpp"

Vec3 mirrored(Vec3 l, Vec3 n) {
  // solution
  return n * (2 * dot(n, l)) - l;
  // start: // Your line here. dot(n, l) is a number; n * 2.0 and n - l are vectors.
  // start: return n + l;
}
// hint: The part of l along n is n * dot(n, l). The rest of l lies along the surface.
// hint: r is the first part minus the rest.
