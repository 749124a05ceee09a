// Exercise 14.1: a can far away
//
// A can is upright. Seen from straight above it is a circle of the radius r around (0, 0), the eye
// is at (fx, fz), up to ten million radii away, and a ray has the direction (dx, dz), of any
// length. It meets the circle where a t t - 2 b t + c = 0, with a = dx dx + dz dz,
// b = -(fx dx + fz dz) and c = fx fx + fz fz - r r. Return b b - a c, off by a millionth of a r r
// at most. All numbers are floats: keep to them, as a graphics card does.
// std::fma(x, y, z) is x y + z, rounded once, at its end; so std::fma(x, y, -x * y) is the rounding
// error of the product x * y.
#include "exercise.hpp"

float discriminant(float fx, float fz, float dx, float dz, float r) {
  // solution
  const float product = fz * dx;
  const float error = std::fma(fz, dx, -product);
  const float aside = std::fma(fx, dz, -product) - error;  // fx dz - fz dx
  return (dx * dx + dz * dz) * r * r - aside * aside;
  // start: // Your lines here.
  // start: return dx * dx + dz * dz - r * r * (fx + fz);
}
// hint: The ray's line passes the axis at a distance h. What is b b - a c, written with a, r and h?
// hint: a h h is the square of fx dz - fz dx, which is f x d seen from above.
// hint: From far away fx dz and fz dx are large and nearly equal: their rounding errors count.
// hint: Another way: start the ray near the can, at f + t d, with a t that brings it there.
