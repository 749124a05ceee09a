// Exercise 02.2: a walk on the map
//
// An ant is at the point p of a sphere with this center and radius. It walks, and on the sphere's
// map it goes by du to the east and by dv to the north: both are parts of the map's width and
// height, negative to the west and to the south. So du = 1 leads once around, and dv = 1/2 from the
// equator to the north pole. It never walks over a pole. Return the point where it arrives.
//
// Check it:  ./course check 02.2
#include "exercise.hpp"

Vec3 after_walk(Vec3 p, Vec3 center, double radius, double du, double dv) {
  // Your lines here. p - center and p / radius are vectors.
  return {p.x + du, p.y + dv, p.z};
}
