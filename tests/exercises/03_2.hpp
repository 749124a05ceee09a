// Exercise 03.2: which row?
//
// A file has several pictures, one below the other, and each has height rows of texels. Rows are
// numbered downward through the whole file: row 0 is the top row of picture 0. But v grows upward:
// at v = 0 you are in a picture's bottom row, at v = 1 in its top row. Return the number of the
// row, in the file, that v is in, in this picture. If v is less than 0 or more than 1, return the
// picture's row at that end.
#include "exercise.hpp"

int row_of(double v, int height, int picture) {
  // solution
  const int from_below = static_cast<int>(v * height);
  return picture * height + height - 1 - std::clamp(from_below, 0, height - 1);
  // start: // Your lines here.
  // start: return height / 2;
}
// hint: Begin with one picture. Count its rows from below first, as you would count columns.
// hint: Its bottom row is 0 when counted from below, and height - 1 when counted downward.
// hint: How many rows are above picture number 1? And above number 2?
