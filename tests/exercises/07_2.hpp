// Exercise 07.2: a window in the ceiling
//
// Light comes through a round window in the ceiling. +z is up. The directions to the window, of
// length 1, are a cap of the sphere of radius 1: its points with z from `edge` to 1. Choose one of
// them so that equal areas of the cap get equally many. Archimedes found: a slice of a sphere has
// an area in proportion to its height, wherever it is cut.
// a and b are random numbers, 0 or more and less than 1. a says how far below the top: a = 0 is
// straight up. b says on which side: at the angle 2 pi b, counted from x toward y.
#include "exercise.hpp"

Vec3 through_window(double a, double b, double edge) {
  // solution
  const double z = 1 - a * (1 - edge);
  const double radius = std::sqrt(1 - z * z);
  const double angle = 2 * pi * b;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
  // start: // Your lines here.
  // start: return normalize(Vec3{a, b, edge});
}
// hint: Slices of the same height have the same area. So z is spread evenly, from 1 down to edge.
// hint: The length is 1 if x x + y y + z z = 1: how far from the axis is a point at the height z?
// hint: A point with radius r and angle w is at (r cos w, r sin w).
