// Exercise 05.1: turn a direction
//
// p is a direction. Return p turned about the x axis by an angle in degrees: the globe nods. A
// positive angle turns from +y to +z: 90 degrees turn (0, 1, 0) to (0, 0, 1), and (0, 0, 1) to
// (0, -1, 0).
//
// Check it:  ./course check 05.1
#include "exercise.hpp"

Vec3 turned(Vec3 p, double degrees) {
  // Your lines here. std::sin and std::cos take an angle in radians.
  return {p.x, p.y + degrees / 360, p.z};
}
