// Exercise 06.2: the highlight
//
// n is the normal, of length 1. to_lamp goes from the point to the lamp and is as long as the way
// to it. d is the direction of the ray, from the eye to the point, of length 1. Return Phong's
// power, the cosine of the angle between the mirrored light and the direction to the eye, raised to
// `shininess`. It is 0 where this cosine is negative, and where the lamp is behind the surface.
#include "exercise.hpp"

double highlight(Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
  // solution
  const Vec3 l = normalize(to_lamp);
  if (dot(n, l) <= 0) return 0;
  const Vec3 r = n * (2 * dot(n, l)) - l;
  const double cosine = dot(r, -d);
  return std::pow(std::max(cosine, 0.0), shininess);
  // start: // Your lines here. std::pow(x, s) is x to the power s.
  // start: return dot(n, to_lamp) * dot(n, d) / shininess;
}
// hint: The cosine of two directions is their dot product, if both have the length 1.
// hint: d goes to the surface. The direction to the eye is the opposite one, -d.
// hint: Limit the cosine before you raise it: std::max(cosine, 0.0).
