// Exercise 03.3: the color of a texel
//
// bytes is a picture as it is in memory: three bytes for each texel, its red, green and blue, from
// 0 to 255. The texels follow each other row after row from the top, and each row from the left.
// bytes[i] is the byte number i, an int; the first one is bytes[0]. Return the color of the texel
// in this column and row, each channel from 0 to 1.
//
// Check it:  ./course check 03.3
#include "exercise.hpp"

Color color_of(const Bytes& bytes, int width, int column, int row) {
  // Your lines here.
  return {bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0};
}
