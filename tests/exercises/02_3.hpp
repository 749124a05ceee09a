// Exercise 02.3: bricks
//
// On the equator a square of the checkerboard is twice as wide as it is high, like a brick. In a
// wall every second row is moved by half a brick. So let the squares of rows 1, 3, 5 ... begin half
// a square further west than they do; row 0, at the south pole, and rows 2, 4 ... stay.
// The checkerboard has `squares` rows and as many columns, an even number. uv is what the lesson's
// mapping gives. Return what the checkerboard should get in its place. Its u may be more than 1:
// there the checkerboard goes on in the same way.
#include "exercise.hpp"

Uv as_bricks(Uv uv, int squares) {
  // solution
  const int row = static_cast<int>(std::floor(uv.v * squares));
  return {row % 2 == 0 ? uv.u : uv.u + 0.5 / squares, uv.v};
  // start: // Your lines here.
  // start: return uv;
}
// hint: Which row is uv in? The page has a formula for it.
// hint: A square is 1 / squares wide. In C++ that is 0 for whole numbers: write 1.0 / squares.
// hint: At u = 0 a moved row has the color that is usually half a square further east.
