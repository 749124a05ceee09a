// Exercise 11.1: the normal of a bump
//
// The heights of a surface are known at three places: here, one step to the right and one step up.
// Right, up and out of the flat surface are the x, y and z axes, so its own normal is (0, 0, 1).
// Return the unit normal of the raised surface. It leans downhill.
#include "exercise.hpp"

Vec3 bump_normal(double here, double right, double up, double step) {
  // solution
  const double slope_right = (right - here) / step;
  const double slope_up = (up - here) / step;
  return normalize(Vec3{-slope_right, -slope_up, 1});
  // start: // Your lines here. normalize(Vec3{x, y, z}) has the length 1.
  // start: return {right - here, up - here, step};
}
// hint: A slope is the difference of two heights divided by the step.
// hint: n' = n - the gradient. Here n is (0, 0, 1) and the gradient (slope_right, slope_up, 0).
