// Exercise 01.1: where the ray meets the sphere
//
// The points of a ray are origin + t * direction, t > 0. Return the t of the first point that is
// also on the sphere: |point - center| = radius. Return infinity if there is no such point ahead.
// The direction may have any length; the origin may be inside the sphere.
//
// Check it:  ./course check 01.1
#include "exercise.hpp"

double distance_to_sphere(Vec3 origin, Vec3 direction, Vec3 center, double radius) {
  // Your lines here. dot(v, w) is there, and infinity, and all of <cmath>.
  return length(center - origin) - radius;
}
