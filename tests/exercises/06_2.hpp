// Exercise 06.2: a highlight without a mirror
//
// Jim Blinn's highlight needs no mirrored direction. It looks for the normal that a mirror would
// need to send the lamp's light to the eye: it points halfway between the direction to the lamp and
// the direction to the eye. Return the cosine of the angle between n and this direction, raised to
// `shininess`, and 0 where the lamp is behind the surface.
// n is the surface's normal, of length 1. to_lamp goes from the point to the lamp and is as long as
// the way to it. d is the direction of the ray, from the eye to the point, of length 1.
#include "exercise.hpp"

double highlight(Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
  // solution
  const Vec3 l = normalize(to_lamp);
  if (dot(n, l) <= 0) return 0;
  const Vec3 halfway = normalize(l - d);
  return std::pow(dot(n, halfway), shininess);
  // start: // Your lines here. std::pow(x, s) is x to the power s.
  // start: return dot(n, to_lamp) * dot(n, d) / shininess;
}
// hint: d goes to the surface. The direction to the eye is the opposite one, -d.
// hint: The sum of two vectors of the same length lies halfway between them: draw them as arrows.
// hint: The dot product is the cosine for vectors of length 1. Which length has your sum?
