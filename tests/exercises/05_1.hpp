// Exercise 05.1: turn a direction
//
// p is a direction. Return p turned about the y axis by an angle in degrees. A positive angle turns
// from +z to +x: 90 degrees turn (0, 0, 1) to (1, 0, 0), and (1, 0, 0) to (0, 0, -1).
#include "exercise.hpp"

Vec3 turned(Vec3 p, double degrees) {
  // solution
  const double angle = degrees * pi / 180;
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  return {p.x * c + p.z * s, p.y, p.z * c - p.x * s};
  // start: // Your lines here. std::sin and std::cos take an angle in radians.
  // start: return {p.x + degrees / 360, p.y, p.z};
}
// hint: A full turn is 360 degrees, and 2 pi in radians. So radians are degrees * pi / 180.
// hint: From above, the x axis (1, 0) turns to (cos, -sin), and the z axis (0, 1) to (sin, cos).
// hint: (x, z) goes x steps along the turned x axis and z steps along the turned z axis.
