// Exercise 03.1: which column?
//
// A picture has width columns of texels, numbered from 0 on the left. Together they cover u from
// 0 to 1. Return the number of the column that u is in. At u = 1 it is the last one. If u is less
// than 0 or more than 1, return the first or the last column.
#include "exercise.hpp"

int column_of(double u, int width) {
  // solution
  const int column = static_cast<int>(u * width);
  return std::clamp(column, 0, width - 1);
  // start: // Your lines here.
  // start: return width / 2;
}
// hint: Each column is 1 / width wide. So u * width says how many columns are left of u.
// hint: static_cast<int>(x) cuts off the decimals of x.
// hint: At u = 1 this gives width, one too many. std::clamp(column, 0, width - 1) limits it.
