// Exercise 01.1: where the ray meets the sphere
//
// The upper part of the sphere is cut away. A bowl is left: its points have y <= rim. The points of
// a ray are origin + t * direction, t > 0. Return the t of the first one that is on the bowl, from
// outside or from inside, and infinity if there is none ahead. The direction may have any length.
//
// Check it:  ./course check 01.1
#include "exercise.hpp"

double distance_to_bowl(Vec3 origin, Vec3 direction, Vec3 center, double radius, double rim) {
  // Your lines here. dot(v, w) is there, and infinity, and all of <cmath>.
  return length(center - origin) - radius;
}
