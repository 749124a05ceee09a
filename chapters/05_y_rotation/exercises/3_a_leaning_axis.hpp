// Exercise 05.3: a leaning axis
//
// The globe's axis leans to the right: its north pole is in the direction (sin, cos, 0) of the
// angle `lean`. p is a direction from the center as the eye sees it. Return the direction that goes
// into the mapping, where the north pole is (0, 1, 0): first undo the lean, then turn the direction
// about y by `turn`, from +z to +x. Both angles are in degrees. (The picture then turns the other
// way, to the west.)
//
// Check it:  ./course check 05.3
#include "exercise.hpp"

Vec3 looked_up(Vec3 p, double lean, double turn) {
  // Your lines here. Each angle rotates in a plane: the lean in that of x and y.
  return {p.x, p.y + lean / 90, p.z + turn / 90};
}
