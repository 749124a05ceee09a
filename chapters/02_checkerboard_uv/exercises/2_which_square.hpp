// Exercise 02.2: which square?
//
// The map is divided into fields: into columns by u and rows by v. `squares` is the number of the
// columns, and also of the rows. The two colors of the fields alternate in both directions. Return
// true where (u, v) is in a field of the first color, which is that of the field at (0, 0).
// u is at least 0 and less than 1. v is 0 to 1: at the north pole v is 1, and that belongs to the
// last row.
//
// Check it:  ./course check 02.2
#include "exercise.hpp"

bool is_first_color(Uv uv, int squares) {
  // Your lines here. uv.u * squares says how many columns are left of u.
  return uv.u * squares < 1;
}
