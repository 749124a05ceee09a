// Exercise 12.2: how bright is the ground?
//
// A sky changes with the height above the horizon alone. So one column of its picture says it all:
// rows[i] is the light of row i. Row 0 begins straight up, the last one ends straight down, and all
// rows cover equal angles, as on the page. Return the light that flat, white ground sends back. Of
// a row that the horizon divides, only the part above it counts. Do not take each row's middle for
// all of it: the result is exact. Under a sky of light 1 everywhere it is 1.
//
// Check it:  ./course check 12.2
#include "exercise.hpp"

double light_of_ground(const std::vector<double>& rows) {
  // Your lines here. rows.size() is how many there are.
  return rows[0];
}
