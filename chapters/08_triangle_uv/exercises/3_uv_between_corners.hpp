// Exercise 08.3: (u, v) between the corners
//
// a, b and c are the texture coordinates of a triangle's corners, and `weights` are the weights of
// these corners at a point of the triangle. Return the texture coordinates of the point.
//
// Check it:  ./course check 08.3
#include "exercise.hpp"

Uv mixed(Uv a, Uv b, Uv c, std::array<double, 3> weights) {
  // Your lines here. weights[0] is the weight of a.
  return {a.u + weights[0], b.v + c.v};
}
