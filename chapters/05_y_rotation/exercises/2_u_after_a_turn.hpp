// Exercise 05.2: u after a turn
//
// A point of the globe has this u, 0 or more and less than 1. The globe's direction is turned by an
// angle in degrees, to the east if it is positive. Return the new u, again 0 or more and less than
// 1. The angle may be negative, and it may be more than a full turn.
//
// Check it:  ./course check 05.2
#include "exercise.hpp"

double u_after(double u, double degrees) {
  // Your lines here. How much of a full turn is the angle?
  return u * degrees;
}
