// Exercise 04.1: another convention
//
// A picture was made for the convention of the daily exercise:
//   u grows from east to west: 1/4 on -z, 1/2 on +x, 3/4 on +z; the seam is on -x.
//   v grows from north to south: 0 at the north pole +y, 1/2 on the equator, 1 at the south pole.
// p is a point of the unit sphere around the origin. Return its u and v in this convention.
#include "exercise.hpp"

Uv uv_of(Vec3 p) {
  // solution
  const double u = 0.5 + std::atan2(p.z, p.x) / (2 * pi);
  const double v = std::acos(std::clamp(p.y, -1.0, 1.0)) / pi;
  return {u, v};
  // start: // This is the convention of chapter 02. Two signs are different here.
  // start: const double u = 0.5 + std::atan2(-p.z, p.x) / (2 * pi);
  // start: const double v = std::acos(std::clamp(-p.y, -1.0, 1.0)) / pi;
  // start: return {u, v};
}
// hint: Chapter 02's u grows to the east because of the minus in -p.z.
// hint: std::acos(-p.y) is the angle from the south pole. Which one is the angle from the north?
