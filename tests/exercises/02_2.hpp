// Exercise 02.2: which square?
//
// Here the pattern needs no (u, v). It comes from the place (x, z) in the scene: seen from above,
// there are squares, `size` long and wide, and one of them reaches from (0, 0) to (size, size). Two
// colors alternate in both directions. Return true where (x, z) is in a square of the color of that
// one. x and z can be negative. A square's lower edges, such as x = 0, belong to it.
#include "exercise.hpp"

bool is_first_color(double x, double z, double size) {
  // solution
  const int column = static_cast<int>(std::floor(x / size));
  const int row = static_cast<int>(std::floor(z / size));
  return (column + row) % 2 == 0;
  // start: // Your lines here. x / size is the distance from x = 0, counted in squares.
  // start: return x < size;
}
// hint: std::floor(x / size) is the number of the column; left of x = 0 it is -1, -2 and so on.
// hint: One step to the side or up changes column + row by 1. n % 2 == 0: n is even.
// hint: static_cast<int>(-0.3) is 0, and so is static_cast<int>(0.3). std::floor(-0.3) is -1.
