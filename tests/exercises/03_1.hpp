// Exercise 03.1: which column?
//
// This picture is cut out of a map. It shows the map from u = west to u = east, and has width
// columns of texels there, numbered from 0 on the left. Return the number of the column that u is
// in; a column's left edge belongs to it. At u = east it is the last column. Left of the picture
// return the first column, right of it the last one.
#include "exercise.hpp"

int column_of(double u, int width, double west, double east) {
  // solution
  const double across = (u - west) / (east - west);  // 0 to 1 in the picture
  const int column = static_cast<int>(across * width);
  return std::clamp(column, 0, width - 1);
  // start: // Your lines here.
  // start: return width / 2;
}
// hint: How far is u from the picture's left edge, and how wide is the picture in u?
// hint: (u - west) / (east - west) is 0 at the left edge and 1 at the right one.
// hint: static_cast<int>(x) cuts off the decimals of x. std::clamp(x, low, high) limits x.
