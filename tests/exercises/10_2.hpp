// Exercise 10.2: fold out an octahedron
//
// p is a direction of any length. Divide it by |x| + |y| + |z|: it lies on an octahedron. Seen from
// above, with -z up in the picture, its place is (a, b) = (x, -z). That is all for the upper half.
// The lower half is folded out: where y < 0, the place becomes
//     (sign(a) (1 - |b|), sign(b) (1 - |a|))
// Return (u, v): a and b moved from -1 to 1 to 0 to 1. (sign is 1 for numbers above 0, -1 below.)
#include "exercise.hpp"

Uv on_octahedron(Vec3 p) {
  // solution
  const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
  double a = p.x / s;
  double b = -p.z / s;
  if (p.y < 0) {
    const double a_before = a;
    a = std::copysign(1 - std::abs(b), a);
    b = std::copysign(1 - std::abs(a_before), b);
  }
  return {(1 + a) / 2, (1 + b) / 2};
  // start: // Your lines here. std::abs(x) is |x|; std::copysign(size, x) is size with x's sign.
  // start: return {p.x, -p.z};
}
// hint: First the upper half: s = |x| + |y| + |z|, a = x / s, b = -z / s, u = (1 + a) / 2.
// hint: Where p.y < 0, change a and b. The new b needs the old a: keep it in a variable.
