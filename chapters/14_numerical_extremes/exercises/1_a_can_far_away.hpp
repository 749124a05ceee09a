// Exercise 14.1: a can far away
//
// A can is upright. Seen from straight above it is a circle of the radius r around (0, 0), the eye
// is at (fx, fz), up to ten million radii away, and a ray has the direction (dx, dz), of any
// length. It meets the circle where a t t - 2 b t + c = 0, with a = dx dx + dz dz,
// b = -(fx dx + fz dz) and c = fx fx + fz fz - r r. Return b b - a c, off by a millionth of a r r
// at most. All numbers are floats: keep to them, as a graphics card does.
// std::fma(x, y, z) is x y + z, rounded once, at its end; so std::fma(x, y, -x * y) is the rounding
// error of the product x * y.
//
// Check it:  ./course check 14.1
#include "exercise.hpp"

float discriminant(float fx, float fz, float dx, float dz, float r) {
  // Your lines here.
  return dx * dx + dz * dz - r * r * (fx + fz);
}
