// Exercise 07.2: more light from above
//
// a and b are random numbers, 0 or more and less than 1. Make a direction of length 1 above a
// surface with the normal +z: take the point of the disk that has the radius sqrt(a) and the angle
// 2 pi b, counted from x toward y, and lift it to the hemisphere of radius 1.
#include "exercise.hpp"

Vec3 scattered(double a, double b) {
  // solution
  const double radius = std::sqrt(a);
  const double angle = 2 * pi * b;
  return {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1 - radius * radius)};
  // start: // Your lines here. x and y are those of the point of the disk.
  // start: return {a, b, 1};
}
// hint: A point with radius r and angle w is at (r cos w, r sin w).
// hint: Lifting leaves x and y as they are. The length is 1 if x x + y y + z z = 1.
