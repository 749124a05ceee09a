// Exercise 01.2: how straight the light falls
//
// point is on a surface; normal points away from the surface there, and its length is 1. lamp is
// the lamp's position. Return the cosine of the angle between the normal and the direction to the
// lamp, and 0 if the lamp is behind the surface.
//
// Check it:  ./course check 01.2
#include "exercise.hpp"

double cosine_of(Vec3 point, Vec3 normal, Vec3 lamp) {
  // Your line here. dot(v, w) and normalize(v) are there.
  return 0.5;
}
