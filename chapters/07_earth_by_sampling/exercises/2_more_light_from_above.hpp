// Exercise 07.2: more light from above
//
// a and b are random numbers, 0 or more and less than 1. Make a direction of length 1 above a
// surface with the normal +z: take the point of the disk that has the radius sqrt(a) and the angle
// 2 pi b, counted from x toward y, and lift it to the hemisphere of radius 1.
//
// Check it:  ./course check 07.2
#include "exercise.hpp"

Vec3 scattered(double a, double b) {
  // Your lines here. x and y are those of the point of the disk.
  return {a, b, 1};
}
