// Exercise 02.1: where on the map?
//
// This map begins at Greenwich: its seam is on +x. p is a point of the unit sphere around the
// origin. Return its place (u, v) on this map:
//   u grows from west to east: 0 on +x, 1/4 on -z, 1/2 on -x, 3/4 on +z. But for rounding
//   it is less than 1.
//   v grows from south to north: 0 at the south pole -y, 1/2 on the equator, 1 at the pole +y.
//
// Check it:  ./course check 02.1
#include "exercise.hpp"

Uv uv_of(Vec3 p) {
  // Your lines here. Vec3 has .x, .y and .z; pi is there, and all of <cmath>.
  // C++ reads a / 2 * pi as (a / 2) * pi. To divide by both, write a / (2 * pi).
  return {p.x, p.y};
}
