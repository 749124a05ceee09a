// Exercise 08.2: where is this texel?
//
// a, b and c are the corners of a triangle in space, uv_a, uv_b and uv_c their texture coordinates.
// Return the point of space where `at`, a place in the texture, is seen. The triangle's plane goes
// on beyond its edges, and so do (u, v): `at` can be there, too. In the texture the corners run
// counterclockwise or clockwise, and they are not on one line.
#include "exercise.hpp"

Vec3 point_of(Uv at, Vec3 a, Vec3 b, Vec3 c, Uv uv_a, Uv uv_b, Uv uv_c) {
  // solution
  const auto area = [](Uv p, Uv q, Uv r) {  // twice, and below 0 if clockwise
    return (q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u);
  };
  const double whole = area(uv_a, uv_b, uv_c);
  const double of_a = area(at, uv_b, uv_c) / whole;
  const double of_b = area(at, uv_c, uv_a) / whole;
  return a * of_a + b * of_b + c * (1 - of_a - of_b);
  // start: // Your lines here. a * 2.0 and a + b are vectors; at.u and at.v are numbers.
  // start: return a + (b - a) * at.u + (c - a) * at.v;
}
// hint: `at` cuts the triangle of the texture into three. What is the weight of a?
// hint: The edge function is about (0, 0). For `at` take the differences from it.
// hint: The same weights mix the corners in space: a * of_a + b * of_b + c * of_c.
