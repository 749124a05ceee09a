// Exercise 07.2: a window in the ceiling
//
// Light comes through a round window in the ceiling. +z is up. The directions to the window, of
// length 1, are a cap of the sphere of radius 1: its points with z from `edge` to 1. Choose one of
// them so that equal areas of the cap get equally many. Archimedes found: a slice of a sphere has
// an area in proportion to its height, wherever it is cut.
// a and b are random numbers, 0 or more and less than 1. a says how far below the top: a = 0 is
// straight up. b says on which side: at the angle 2 pi b, counted from x toward y.
//
// Check it:  ./course check 07.2
#include "exercise.hpp"

Vec3 through_window(double a, double b, double edge) {
  // Your lines here.
  return normalize(Vec3{a, b, edge});
}
