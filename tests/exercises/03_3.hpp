// Exercise 03.3: the color of a texel
//
// bytes is a picture as it is in memory: three bytes for each texel, its red, green and blue, from
// 0 to 255. The texels follow each other row after row from the top, and each row from the left.
// bytes[i] is the byte number i, an int; the first one is bytes[0]. Return the color of the texel
// in this column and row, each channel from 0 to 1.
#include "exercise.hpp"

Color color_of(const Bytes& bytes, int width, int column, int row) {
  // solution
  const int first = 3 * (row * width + column);
  return {bytes[first] / 255.0, bytes[first + 1] / 255.0, bytes[first + 2] / 255.0};
  // start: // Your lines here.
  // start: return {bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0};
}
// hint: Before the texel there are row whole rows of width texels, and column more texels.
// hint: Each of them has three bytes. After them come this texel's red, green and blue.
// hint: bytes[i] / 255 divides whole numbers: 254 / 255 is 0. Divide by 255.0.
