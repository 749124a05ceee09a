// Exercise 08.3: (u, v) between the corners
//
// a, b and c are the texture coordinates of a triangle's corners, and `weights` are the weights of
// these corners at a point of the triangle. Return the texture coordinates of the point.
#include "exercise.hpp"

Uv mixed(Uv a, Uv b, Uv c, std::array<double, 3> weights) {
  // solution
  return {weights[0] * a.u + weights[1] * b.u + weights[2] * c.u,
          weights[0] * a.v + weights[1] * b.v + weights[2] * c.v};
  // start: // Your lines here. weights[0] is the weight of a.
  // start: return {a.u + weights[0], b.v + c.v};
}
// hint: At corner b the weights are (0, 1, 0), and the result is b.
// hint: Each coordinate is a sum of three products. u and v are mixed in the same way.
