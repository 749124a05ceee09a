// Exercise 10.1: onto a cylinder
//
// p is a point of the unit sphere around the origin. It moves straight out, away from the y axis,
// to a cylinder around the sphere. The unrolled cylinder is the picture. Return p's place on it:
//   u runs around as on page 02: 1/4 on +z, 1/2 on +x, 3/4 on -z; the seam is on -x.
//   v is the height on the cylinder: 0 at y = -1, 1/2 at y = 0, 1 at y = 1.
#include "exercise.hpp"

Uv on_cylinder(Vec3 p) {
  // solution
  const double u = 0.5 - std::atan2(p.z, p.x) / (2 * pi);
  const double v = (1 + p.y) / 2;
  return {u, v};
  // start: // Your lines here. Vec3 has .x, .y and .z; pi is there, and all of <cmath>.
  // start: return {p.x, p.y};
}
// hint: The angle around the axis is std::atan2(p.z, p.x), in radians. It grows westward.
// hint: v does not need an angle: the height is p.y, -1 to 1. Move it to 0 to 1.
