// Exercise 01.3: a row of lamps
//
// In place of one lamp there are several small ones; `lamps` has their positions. point is on a
// sphere, normal points away from it. Return the share of the lamps that the point sees, 0 to 1:
// those with no sphere between them and the point.
// Ask first_hit(start, direction), which looks along a ray: it returns the distance to the first
// sphere, in lengths of direction, or infinity. Rounding puts the point a little above or below the
// sphere that it is on. So let the ray start 0.001 above the point.
//
// Check it:  ./course check 01.3
#include "exercise.hpp"

double visible(Vec3 point, Vec3 normal, const std::vector<Vec3>& lamps, const FirstHit& first_hit) {
  // Your lines here. `for (Vec3 lamp : lamps)` goes through all of them; lamps.size() is
  // how many there are. length(v) and normalize(v) are there.
  return 0.5;
}
