// Exercise 02.2: which square?
//
// The map is divided into squares: into columns by u and rows by v. `squares` is the number of the
// columns, and also of the rows. The two colors of the squares alternate in both directions. Return
// true where (u, v) is in a square of the color of the lower left one, the square at (0, 0).
// u is at least 0 and less than 1. v is 0 to 1: at the north pole v is 1, and that belongs to the
// last row.
#include "exercise.hpp"

bool is_first_color(Uv uv, int squares) {
  // solution
  const int column = static_cast<int>(uv.u * squares);
  const int row = std::min(static_cast<int>(uv.v * squares), squares - 1);
  return (column + row) % 2 == 0;
  // start: // Your lines here. uv.u * squares says how many columns are left of u.
  // start: return uv.u * squares < 1;
}
// hint: static_cast<int>(uv.u * squares) is the number of the column. The row comes from v.
// hint: One step to the side or up changes column + row by 1. n % 2 == 0: n is even.
// hint: At v = 1 the row is one too many. std::min(row, squares - 1) puts it into the last.
