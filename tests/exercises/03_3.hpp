// Exercise 03.3: the color of a texel
//
// bytes is a picture as some libraries keep it: three bytes for each texel, from 0 to 255, first
// its blue, then green, then red. The rows follow each other from the top, each from the left. A
// row begins row_bytes bytes after the one above: it can have a few bytes more than its texels.
// bytes[i] is the byte number i, an int; the first one is bytes[0]. Return the color of the texel
// in this column and row, each channel from 0 to 1.
#include "exercise.hpp"

Color color_of(const Bytes& bytes, int row_bytes, int column, int row) {
  // solution
  const int first = row * row_bytes + 3 * column;
  return {bytes[first + 2] / 255.0, bytes[first + 1] / 255.0, bytes[first] / 255.0};
  // start: // Your lines here.
  // start: return {bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0};
}
// hint: Before the texel's row there are row whole rows, each row_bytes long.
// hint: In its row, column texels come before it, each of three bytes.
// hint: bytes[i] / 255 divides whole numbers: 254 / 255 is 0. Divide by 255.0.
