// Exercise 01.2: how straight the light falls
//
// point is on a surface; normal points away from the surface there, and its length is 1. lamp is
// the lamp's position. Return the cosine of the angle between the normal and the direction to the
// lamp, and 0 if the lamp is behind the surface.
//
// Check it:  ./course check 01.2
#include "exercise.hpp"

double cosine_of(Vec3 point, Vec3 normal, Vec3 lamp) {
  // Your line here. dot(v, w), normalize(v) and std::max(x, y) are there.
  // std::max needs two numbers of one type: write 0.0, because 0 is an int.
  return 0.5;
}
