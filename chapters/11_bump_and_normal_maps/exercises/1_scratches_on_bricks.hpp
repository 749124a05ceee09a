// Exercise 11.1: scratches on bricks
//
// A wall has two normal maps: one has bricks, the other scratches. Their heights add up. `bricks`
// and `scratches` are the normals of the two maps at one place, of length 1, with x to the right, y
// up and z out of the wall; z is above 0. Return the normal of the scratched bricks, of length 1.
//
// Check it:  ./course check 11.1
#include "exercise.hpp"

Vec3 scratched(Vec3 bricks, Vec3 scratches) {
  // Your lines here. normalize(Vec3{x, y, z}) has the length 1.
  return normalize(cross(bricks, scratches));
}
