// Exercise 04.2: the columns of another program
//
// A picture was made for the lecture's convention: u is 0 on +z and grows to the east. It is to be
// written anew for a program with the daily exercise's convention: u is 0 on -x and grows to the
// west. Both pictures have `width` columns of texels, a multiple of 4, numbered from 0 on the left:
// column k reaches from u = k / width to u = (k + 1) / width.
// Return the column of the old picture that belongs in this column of the new one.
//
// Check it:  ./course check 04.2
#include "exercise.hpp"

int old_column(int column, int width) {
  // Your lines here.
  return column;
}
