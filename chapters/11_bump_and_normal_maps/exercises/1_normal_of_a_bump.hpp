// Exercise 11.1: the normal of a bump
//
// The heights of a surface are known at three places: here, one step to the right and one step up.
// Right, up and out of the flat surface are the x, y and z axes, so its own normal is (0, 0, 1).
// Return the unit normal of the raised surface. It leans downhill.
//
// Check it:  ./course check 11.1
#include "exercise.hpp"

Vec3 bump_normal(double here, double right, double up, double step) {
  // Your lines here. normalize(Vec3{x, y, z}) has the length 1.
  return {right - here, up - here, step};
}
