// Exercise 02.2: which square?
//
// The map is divided into squares: into columns by u and rows by v. `squares` is the number of the
// columns, and also of the rows. The two colors of the squares alternate in both directions. Return
// true where (u, v) is in a square of the color of the lower left one, the square at (0, 0).
// u is at least 0 and less than 1. v is 0 to 1: at the north pole v is 1, and that belongs to the
// last row.
//
// Check it:  ./course check 02.2
#include "exercise.hpp"

bool is_first_color(Uv uv, int squares) {
  // Your lines here. uv.u * squares says how many columns are left of u.
  return uv.u * squares < 1;
}
