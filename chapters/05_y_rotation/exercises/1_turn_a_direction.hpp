// Exercise 05.1: turn a direction
//
// p is a direction. Return p turned about the y axis by an angle in degrees. A positive angle turns
// from +z to +x: 90 degrees turn (0, 0, 1) to (1, 0, 0), and (1, 0, 0) to (0, 0, -1).
//
// Check it:  ./course check 05.1
#include "exercise.hpp"

Vec3 turned(Vec3 p, double degrees) {
  // Your lines here. std::sin and std::cos take an angle in radians.
  return {p.x + degrees / 360, p.y, p.z};
}
