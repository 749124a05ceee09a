// Exercise 04.1: any convention
//
// A convention answers three questions. `seam` is the point of the equator where u is 0. u grows to
// the east if u_to_east is true, otherwise to the west. v grows to the north, from 0 to 1, if
// v_to_north is true, otherwise to the south. p is a point of the unit sphere around the origin.
// Return its u and v in this convention. u is 0 or more and, but for rounding, less than 1.
//
// Check it:  ./course check 04.1
#include "exercise.hpp"

Uv uv_in(Vec3 p, Vec3 seam, bool u_to_east, bool v_to_north) {
  // This is right for one convention, that of chapter 02.
  const double u = 0.5 + std::atan2(-p.z, p.x) / (2 * pi);
  const double v = std::acos(std::clamp(-p.y, -1.0, 1.0)) / pi;
  return {u, v};
}
