// Exercise 06.2: a highlight without a mirror
//
// Jim Blinn's highlight needs no mirrored direction. It looks for the normal that a mirror would
// need to send the lamp's light to the eye: it points halfway between the direction to the lamp and
// the direction to the eye. Return the cosine of the angle between n and this direction, raised to
// `shininess`, and 0 where the lamp is behind the surface.
// n is the surface's normal, of length 1. to_lamp goes from the point to the lamp and is as long as
// the way to it. d is the direction of the ray, from the eye to the point, of length 1.
//
// Check it:  ./course check 06.2
#include "exercise.hpp"

double highlight(Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
  // Your lines here. std::pow(x, s) is x to the power s.
  return dot(n, to_lamp) * dot(n, d) / shininess;
}
