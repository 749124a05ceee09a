// Exercise 01.3: a row of lamps
//
// In place of one lamp there are several small ones; `lamps` has their positions. point is on a
// sphere, normal points away from it. Return the share of the lamps that the point sees, 0 to 1:
// those with no sphere between them and the point.
// Ask first_hit(start, direction), which looks along a ray: it returns the distance to the first
// sphere, in lengths of direction, or infinity. Rounding puts the point a little above or below the
// sphere that it is on. So let the ray start 0.001 above the point.
#include "exercise.hpp"

double visible(Vec3 point, Vec3 normal, const std::vector<Vec3>& lamps, const FirstHit& first_hit) {
  // solution
  const Vec3 start = point + normal * 0.001;
  double seen = 0;
  for (const Vec3& lamp : lamps) {
    const Vec3 path = lamp - start;
    if (first_hit(start, normalize(path)) >= length(path)) seen += 1;
  }
  return seen / static_cast<double>(lamps.size());
  // start: // Your lines here. `for (Vec3 lamp : lamps)` goes through all of them; lamps.size() is
  // start: // how many there are. length(v) and normalize(v) are there.
  // start: return 0.5;
}
// hint: For each lamp: the ray starts at point + normal * 0.001 and goes to the lamp.
// hint: A sphere behind the lamp does not hide it: compare with the distance of the lamp.
// hint: Count the lamps that are not hidden, in a double: 3 / 4 of two whole numbers is 0.
