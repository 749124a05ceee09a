// Exercise 12.2: how much of the sphere is a texel?
//
// An equirectangular sky has `width` texels in each of `height` rows. Row 0 is at the north pole.
// Each row covers pi / height of the polar angle, and each texel of it 2 pi / width of the turn
// around the axis. Return the solid angle of one texel of a row: 2 pi / width times the integral of
// the sine from the row's upper edge a to its lower edge b, which is cos a - cos b.
//
// Check it:  ./course check 12.2
#include "exercise.hpp"

double solid_angle(int row, int width, int height) {
  // Your lines here. All texels together must have 4 pi.
  return 4 * pi / width / height * (row < height ? 1 : 0);
}
