// Exercise 06.2: the highlight
//
// n is the normal, of length 1. to_lamp goes from the point to the lamp and is as long as the way
// to it. d is the direction of the ray, from the eye to the point, of length 1. Return Phong's
// power, the cosine of the angle between the mirrored light and the direction to the eye, raised to
// `shininess`. It is 0 where this cosine is negative, and where the lamp is behind the surface.
//
// Check it:  ./course check 06.2
#include "exercise.hpp"

double highlight(Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
  // Your lines here. std::pow(x, s) is x to the power s.
  return dot(n, to_lamp) * dot(n, d) / shininess;
}
