// Exercise 03.3: the color of a texel
//
// bytes is a picture as some libraries keep it: three bytes for each texel, from 0 to 255, first
// its blue, then green, then red. The rows follow each other from the top, each from the left. A
// row begins row_bytes bytes after the one above: it can have a few bytes more than its texels.
// bytes[i] is the byte number i, an int; the first one is bytes[0]. Return the color of the texel
// in this column and row, each channel from 0 to 1.
//
// Check it:  ./course check 03.3
#include "exercise.hpp"

Color color_of(const Bytes& bytes, int row_bytes, int column, int row) {
  // Your lines here.
  return {bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0};
}
