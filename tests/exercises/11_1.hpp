// Exercise 11.1: scratches on bricks
//
// A wall has two normal maps: one has bricks, the other scratches. Their heights add up. `bricks`
// and `scratches` are the normals of the two maps at one place, of length 1, with x to the right, y
// up and z out of the wall; z is above 0. Return the normal of the scratched bricks, of length 1.
#include "exercise.hpp"

Vec3 scratched(Vec3 bricks, Vec3 scratches) {
  // solution
  const Vec3 sum = bricks / bricks.z + scratches / scratches.z;  // slopes add up
  return normalize(Vec3{sum.x, sum.y, 1});
  // start: // Your lines here. normalize(Vec3{x, y, z}) has the length 1.
  // start: return normalize(cross(bricks, scratches));
}
// hint: If heights add up, what adds up of n' = n - the gradient?
// hint: Which slopes has a wall with the normal (-0.6, 0, 0.8)? n is (0, 0, 1) here.
// hint: The normal was divided by its length. Divide it by z, and the slopes come out of it.
