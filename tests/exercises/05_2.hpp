// Exercise 05.2: u after a turn
//
// A point of the globe has this u, 0 or more and less than 1. The globe's direction is turned by an
// angle in degrees, to the east if it is positive. Return the new u, again 0 or more and less than
// 1. The angle may be negative, and it may be more than a full turn.
#include "exercise.hpp"

double u_after(double u, double degrees) {
  // solution
  const double turns = u + degrees / 360;
  return turns - std::floor(turns);
  // start: // Your lines here. How much of a full turn is the angle?
  // start: return u * degrees;
}
// hint: A full turn is 360 degrees, and it adds 1 to u.
// hint: Only the part after the decimal point counts. std::floor(x) is the whole number below x.
// hint: -0.25 is u = 0.75. std::floor(-0.25) is -1, but static_cast<int>(-0.25) is 0.
