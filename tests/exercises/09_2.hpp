// Exercise 09.2: mix two texels
//
// A row of a picture has `width` texels, u runs from 0 to 1. So u * width is the place in texels:
// texel k reaches from k to k + 1, and its center is at k + 1/2. A place lies between the centers
// of two texels. The bilinear filter mixes both: at a center only that texel counts, halfway
// between two centers both count 1/2, and between these the weights change evenly.
// Return the weight of the texel on the left and the weight of the texel on the right.
#include "exercise.hpp"

std::array<double, 2> weights_of(double u, int width) {
  // solution
  const double x = u * width - 0.5;  // centers are now at whole numbers
  const double right = x - std::floor(x);
  return {1 - right, right};
  // start: // Your lines here. The lesson finds the two texels, it only needs their weights.
  // start: return {u * width, 1 - u * width};
}
// hint: Move the centers to whole numbers: x = u * width - 0.5.
// hint: std::floor(x) is the center on the left. How far is x from it? That is one of the weights.
// hint: Closer to the right center, the right texel counts more. Both weights add up to 1.
