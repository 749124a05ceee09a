// Exercise 01.3: is the lamp hidden?
//
// point is on a sphere, normal points away from it, lamp is the lamp's position. Return true if a
// sphere is between the point and the lamp. Ask first_hit(start, direction), which looks along a
// ray: it returns the distance to the first sphere, in lengths of direction, or infinity.
// Rounding puts the point a little above or below the sphere that it is on. So let the ray start
// 0.001 above the point.
#include "exercise.hpp"

bool in_shadow(Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit) {
  // solution
  const Vec3 start = point + normal * 0.001;
  const Vec3 path = lamp - start;
  return first_hit(start, normalize(path)) < length(path);
  // start: // Your lines here. length(v) and normalize(v) are there.
  // start: return false;
}
// hint: The ray starts at point + normal * 0.001 and goes to the lamp.
// hint: A sphere behind the lamp casts no shadow here: compare with the distance of the lamp.
