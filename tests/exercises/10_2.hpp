// Exercise 10.2: a sky on half an octahedron
//
// A sky needs the upper half of all directions, so the upper four faces of the octahedron will do.
// Seen from above they fill a square that stands on its corner. Turn this square clockwise, by an
// eighth of a turn, so that it stands on a side, and enlarge it so that it fills the picture: +x is
// then in the lower right corner, and -z in the upper right one.
// p is a direction of any length with y at least 0. Return its place (u, v).
#include "exercise.hpp"

Uv on_half_octahedron(Vec3 p) {
  // solution
  const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
  const double a = p.x / s;
  const double b = -p.z / s;
  return {(1 + a + b) / 2, (1 - a + b) / 2};
  // start: // Your lines here. std::abs(x) is |x|.
  // start: return {p.x, -p.z};
}
// hint: Before the turn +x is at (a, b) = (1, 0), -z at (0, 1) and the zenith at (0, 0).
// hint: Turned and enlarged, with (0, 0) still in the middle, (1, 0) is at (1, -1). And (0, 1)?
// hint: A turn takes a times the place of (1, 0) plus b times the place of (0, 1).
