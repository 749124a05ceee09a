// Exercise 08.2: the three weights
//
// a, b and c are the corners of a triangle as the ray sees them: x and y are their places, and the
// ray goes through the triangle at (0, 0). Return the weights of a, b and c there. Their sum is 1.
#include "exercise.hpp"

std::array<double, 3> weights(Vec3 a, Vec3 b, Vec3 c) {
  // solution
  const double ab = a.x * b.y - a.y * b.x;
  const double bc = b.x * c.y - b.y * c.x;
  const double ca = c.x * a.y - c.y * a.x;
  const double whole = ab + bc + ca;
  return {bc / whole, ca / whole, ab / whole};
  // start: // Your lines here. a.x * b.y - a.y * b.x is twice the area of (0, 0), a and b.
  // start: return {a.x, b.x, c.x};
}
// hint: A corner's weight is the share of the small triangle opposite it: b, c and the ray for a.
// hint: The three small triangles together are the whole one.
