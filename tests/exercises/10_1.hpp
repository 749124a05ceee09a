// Exercise 10.1: a round map
//
// A round map shows the whole Earth. The north pole is in its middle, and the south pole is all of
// its rim. Equal areas of the Earth have equal areas on the map. The rim is a circle that touches
// the four sides of the unit square. Straight lines lead from the pole outward: seen from above,
// each point is in the direction in which it is on the Earth, with +x to the right and -z up.
// p is a direction of length 1. Return its place (u, v).
#include "exercise.hpp"

Uv on_round_map(Vec3 p) {
  // solution
  const double from_axis = std::hypot(p.x, p.z);
  if (from_axis == 0) return {p.y > 0 ? 0.5 : 1, 0.5};  // the middle; a point of the rim
  const double radius = std::sqrt((1 - p.y) / 2) / 2;
  return {0.5 + radius * p.x / from_axis, 0.5 - radius * p.z / from_axis};
  // start: // Your lines here.
  // start: return {p.x, p.y};
}
// hint: The cap of the sphere from the pole down to the height y has the area 2 pi (1 - y).
// hint: All of the sphere, 4 pi, fills a circle of radius 1/2. Which circle has the cap's share?
// hint: Seen from above p lies in the direction (x, -z). Make that a vector of length 1 first.
// hint: At the pole itself this vector is 0, and 0 / 0 is no number.
