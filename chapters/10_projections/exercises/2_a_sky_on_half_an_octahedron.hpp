// Exercise 10.2: a sky on half an octahedron
//
// A sky needs the upper half of all directions, so the upper four faces of the octahedron will do.
// Seen from above they fill a square that stands on its corner. Turn this square clockwise, by an
// eighth of a turn, so that it stands on a side, and enlarge it so that it fills the picture: +x is
// then in the lower right corner, and -z in the upper right one.
// p is a direction of any length with y at least 0. Return its place (u, v).
//
// Check it:  ./course check 10.2
#include "exercise.hpp"

Uv on_half_octahedron(Vec3 p) {
  // Your lines here. std::abs(x) is |x|.
  return {p.x, -p.z};
}
