// Exercise 05.3: a leaning axis
//
// The globe's axis leans to the right: its north pole is in the direction (sin, cos, 0) of the
// angle `lean`. p is a direction from the center as the eye sees it. Return the direction that goes
// into the mapping, where the north pole is (0, 1, 0): first undo the lean, then turn the direction
// about y by `turn`, from +z to +x. Both angles are in degrees. (The picture then turns the other
// way, to the west.)
#include "exercise.hpp"

Vec3 looked_up(Vec3 p, double lean, double turn) {
  // solution
  const double a = lean * pi / 180;
  const Vec3 upright{p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a),
                     p.z};
  const double b = turn * pi / 180;
  return {upright.x * std::cos(b) + upright.z * std::sin(b), upright.y,
          upright.z * std::cos(b) - upright.x * std::sin(b)};
  // start: // Your lines here. Each angle rotates in a plane: the lean in that of x and y.
  // start: return {p.x, p.y + lean / 90, p.z + turn / 90};
}
// hint: Undoing the lean turns (sin, cos, 0) to (0, 1, 0). z stays as it is.
// hint: Where do the axes go? The x axis turns to (cos, sin), the y axis to (-sin, cos).
// hint: Then turn that direction, not p, about y: x cos + z sin, y, z cos - x sin.
