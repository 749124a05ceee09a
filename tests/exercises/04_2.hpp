// Exercise 04.2: the columns of another program
//
// A picture fits the lecture's convention: u is 0 on +z and grows to the east. Another program has
// the daily exercise's convention: u is 0 on -x and grows to the west. It needs a new picture with
// the same columns in other places. Both pictures have `width` columns of texels, a multiple of 4,
// numbered from 0 on the left: column k reaches from u = k / width to u = (k + 1) / width.
// Return the old picture's column for this column of the new one.
#include "exercise.hpp"

int old_column(int column, int width) {
  // solution
  const int to_the_east = width - 1 - column;  // counted from -x to the east
  return (to_the_east + width - width / 4) % width;
  // start: // Your lines here.
  // start: return column;
}
// hint: Draw 8 columns around the globe, seen from above, and number them in both ways.
// hint: Which column is the new column 0, if you count from -x to the east? It is the last one.
// hint: +z is a quarter of the columns east of -x. Left of column 0 the last one follows.
