// Exercise 05.1: turn a direction
//
// p is a direction. Return p turned about the x axis by an angle in degrees: the globe nods. A
// positive angle turns from +y to +z: 90 degrees turn (0, 1, 0) to (0, 0, 1), and (0, 0, 1) to
// (0, -1, 0).
#include "exercise.hpp"

Vec3 turned(Vec3 p, double degrees) {
  // solution
  const double angle = degrees * pi / 180;
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  return {p.x, p.y * c - p.z * s, p.z * c + p.y * s};
  // start: // Your lines here. std::sin and std::cos take an angle in radians.
  // start: return {p.x, p.y + degrees / 360, p.z};
}
// hint: A full turn is 360 degrees, and 2 pi in radians. So radians are degrees * pi / 180.
// hint: Where do the two axes go? In (y, z), the y axis turns to (cos, sin). And the z axis?
// hint: (y, z) goes y steps along the turned y axis and z steps along the turned z axis.
