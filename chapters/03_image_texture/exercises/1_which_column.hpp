// Exercise 03.1: which column?
//
// This picture is cut out of a map. It shows the map from u = west to u = east, and has width
// columns of texels there, numbered from 0 on the left. Return the number of the column that u is
// in; a column's left edge belongs to it. At u = east it is the last column. Left of the picture
// return the first column, right of it the last one.
//
// Check it:  ./course check 03.1
#include "exercise.hpp"

int column_of(double u, int width, double west, double east) {
  // Your lines here.
  return width / 2;
}
