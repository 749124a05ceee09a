// Exercise 10.1: onto a cylinder
//
// p is a point of the unit sphere around the origin. It moves straight out, away from the y axis,
// to a cylinder around the sphere. The unrolled cylinder is the picture. Return p's place on it:
//   u runs around as on page 02: 1/4 on +z, 1/2 on +x, 3/4 on -z; the seam is on -x.
//   v is the height on the cylinder: 0 at y = -1, 1/2 at y = 0, 1 at y = 1.
//
// Check it:  ./course check 10.1
#include "exercise.hpp"

Uv on_cylinder(Vec3 p) {
  // Your lines here. Vec3 has .x, .y and .z; pi is there, and all of <cmath>.
  return {p.x, p.y};
}
