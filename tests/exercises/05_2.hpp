// Exercise 05.2: a place in the middle
//
// The eye is anywhere around the globe and looks at its center, (0, 0, 0). Which angle, in degrees,
// shows the meridian with this longitude in the middle of the picture? Longitudes are in degrees,
// too: without a turn 0 is on +x, 90 on -z and -90 on +z. As on the page, the angle turns the
// direction that goes into the mapping: to the east if it is positive.
// A full turn more or less shows the same, so it does not count.
#include "exercise.hpp"

double angle_to_show(double longitude, Vec3 eye) {
  // solution
  const double without_a_turn = std::atan2(-eye.z, eye.x) * 180 / pi;
  return longitude - without_a_turn;
  // start: // Your lines here. std::atan2 returns radians, and pi is there.
  // start: return longitude * eye.x;
}
// hint: Which longitude is in the middle without a turn? The eye's own: std::atan2(-eye.z, eye.x).
// hint: Every degree of the turn looks up a place one degree further east.
// hint: Without a turn at longitude -90, and with 90 degrees: -90 + 90 = 0, as on the page.
