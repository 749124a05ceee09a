// Exercise 02.1: where on the map?
//
// This map begins at Greenwich: its seam is on +x. p is a point of the unit sphere around the
// origin. Return its place (u, v) on this map:
//   u grows from west to east: 0 on +x, 1/4 on -z, 1/2 on -x, 3/4 on +z. But for rounding
//   it is less than 1.
//   v grows from south to north: 0 at the south pole -y, 1/2 on the equator, 1 at the pole +y.
#include "exercise.hpp"

Uv uv_of(Vec3 p) {
  // solution
  // std::atan2(-p.z, p.x) is the longitude, -pi to pi. acos needs a number from -1 to 1.
  const double turn = std::atan2(-p.z, p.x) / (2 * pi);
  const double v = std::acos(std::clamp(-p.y, -1.0, 1.0)) / pi;
  return {turn < 0 ? turn + 1 : turn, v};
  // start: // Your lines here. Vec3 has .x, .y and .z; pi is there, and all of <cmath>.
  // start: // C++ reads a / 2 * pi as (a / 2) * pi. To divide by both, write a / (2 * pi).
  // start: return {p.x, p.y};
}
// hint: The longitude is the angle of (x, -z), seen from above: std::atan2(-p.z, p.x).
// hint: West of Greenwich the longitude is negative, and u has to be from 1/2 to 1 there.
// hint: The angle from the south pole is std::acos(-p.y). Divide by what the angles run over.
