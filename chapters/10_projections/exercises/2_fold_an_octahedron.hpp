// Exercise 10.2: fold out an octahedron
//
// p is a direction of any length. Divide it by |x| + |y| + |z|: it lies on an octahedron. Seen from
// above, with -z up in the picture, its place is (a, b) = (x, -z). That is all for the upper half.
// The lower half is folded out: where y < 0, the place becomes
//     (sign(a) (1 - |b|), sign(b) (1 - |a|))
// Return (u, v): a and b moved from -1 to 1 to 0 to 1. (sign is 1 for numbers above 0, -1 below.)
//
// Check it:  ./course check 10.2
#include "exercise.hpp"

Uv on_octahedron(Vec3 p) {
  // Your lines here. std::abs(x) is |x|; std::copysign(size, x) is size with x's sign.
  return {p.x, -p.z};
}
