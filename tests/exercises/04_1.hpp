// Exercise 04.1: any convention
//
// A convention answers three questions. `seam` is the point of the equator where u is 0. u grows to
// the east if u_to_east is true, otherwise to the west. v grows to the north, from 0 to 1, if
// v_to_north is true, otherwise to the south. p is a point of the unit sphere around the origin.
// Return its u and v in this convention. u is 0 or more and, but for rounding, less than 1.
#include "exercise.hpp"

Uv uv_in(Vec3 p, Vec3 seam, bool u_to_east, bool v_to_north) {
  // solution
  const double east = std::atan2(-p.z, p.x) - std::atan2(-seam.z, seam.x);
  const double turns = (u_to_east ? east : -east) / (2 * pi);
  const double from_south = std::acos(std::clamp(-p.y, -1.0, 1.0)) / pi;
  return {turns - std::floor(turns), v_to_north ? from_south : 1 - from_south};
  // start: // This is right for one convention, that of chapter 02.
  // start: const double u = 0.5 + std::atan2(-p.z, p.x) / (2 * pi);
  // start: const double v = std::acos(std::clamp(-p.y, -1.0, 1.0)) / pi;
  // start: return {u, v};
}
// hint: How far to the east of the seam is p? Both have a longitude: std::atan2(-p.z, p.x).
// hint: To the west u is the opposite, -u. A whole turn more or less is the same meridian.
// hint: x - std::floor(x) is x without whole turns, also below 0: std::floor(-0.25) is -1.
