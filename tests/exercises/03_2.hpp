// Exercise 03.2: which row?
//
// A picture file has height rows of texels. It numbers them downward: row 0 is the top row. But v
// grows upward: at v = 0 you are in the bottom row, at v = 1 in the top row. Return the number of
// the row that v is in. If v is less than 0 or more than 1, return the row at that end.
#include "exercise.hpp"

int row_of(double v, int height) {
  // solution
  const int from_below = static_cast<int>(v * height);
  return height - 1 - std::clamp(from_below, 0, height - 1);
  // start: // Your lines here.
  // start: return height / 2;
}
// hint: Count the rows from below first, as you counted the columns from the left.
// hint: The bottom row is 0 when counted from below, and height - 1 in the file.
