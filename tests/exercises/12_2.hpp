// Exercise 12.2: how much of the sphere is a texel?
//
// An equirectangular sky has `width` texels in each of `height` rows. Row 0 is at the north pole.
// Each row covers pi / height of the polar angle, and each texel of it 2 pi / width of the turn
// around the axis. Return the solid angle of one texel of a row: 2 pi / width times the integral of
// the sine from the row's upper edge a to its lower edge b, which is cos a - cos b.
#include "exercise.hpp"

double solid_angle(int row, int width, int height) {
  // solution
  const double a = pi * row / height;
  const double b = pi * (row + 1) / height;
  return 2 * pi / width * (std::cos(a) - std::cos(b));
  // start: // Your lines here. All texels together must have 4 pi.
  // start: return 4 * pi / width / height * (row < height ? 1 : 0);
}
// hint: The upper edge of row 0 has the polar angle 0, the lower edge of the last row has pi.
// hint: a = pi * row / height. The lower edge is the upper edge of the next row.
