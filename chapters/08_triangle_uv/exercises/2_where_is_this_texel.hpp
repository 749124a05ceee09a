// Exercise 08.2: where is this texel?
//
// a, b and c are the corners of a triangle in space, uv_a, uv_b and uv_c their texture coordinates.
// Return the point of space where `at`, a place in the texture, is seen. The triangle's plane goes
// on beyond its edges, and so do (u, v): `at` can be there, too. In the texture the corners run
// counterclockwise or clockwise, and they are not on one line.
//
// Check it:  ./course check 08.2
#include "exercise.hpp"

Vec3 point_of(Uv at, Vec3 a, Vec3 b, Vec3 c, Uv uv_a, Uv uv_b, Uv uv_c) {
  // Your lines here. a * 2.0 and a + b are vectors; at.u and at.v are numbers.
  return a + (b - a) * at.u + (c - a) * at.v;
}
