// Exercise 09.1: the picture again and again
//
// A floor shows its picture again and again. The picture is `width` texels wide; its columns are
// 0 to width - 1, from the left. The ray meets the floor in some column, any whole number, also
// below 0 or beyond the picture. Return the column of the picture that is seen there.
// Example with width 4:  column  -5 -4 -3 -2 -1  0  1  2  3  4  5
//                        seen     3  0  1  2  3  0  1  2  3  0  1
#include "exercise.hpp"

int repeated_column(int column, int width) {
  // solution
  const int rest = column % width;  // C++ keeps the sign of column
  return rest < 0 ? rest + width : rest;
  // start: // Your lines here. The floor is magenta where you return no column of the picture.
  // start: return column < width ? column : 0;
}
// hint: column % width is the rest of the division. Try it for column = -1: it is not width - 1.
// hint: If the rest is below 0, add width.
