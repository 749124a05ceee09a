// Exercise 12.2: how bright is the ground?
//
// A sky changes with the height above the horizon alone. So one column of its picture says it all:
// rows[i] is the light of row i. Row 0 begins straight up, the last one ends straight down, and all
// rows cover equal angles, as on the page. Return the light that flat, white ground sends back. Of
// a row that the horizon divides, only the part above it counts. Do not take each row's middle for
// all of it: the result is exact. Under a sky of light 1 everywhere it is 1.
#include "exercise.hpp"

double light_of_ground(const std::vector<double>& rows) {
  // solution
  const double step = pi / static_cast<double>(rows.size());
  double light = 0;
  double inside = 0;  // of the disk, up to the row
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double radius = std::sin(std::min(static_cast<double>(i + 1) * step, pi / 2));
    light += rows[i] * (radius * radius - inside);
    inside = radius * radius;
  }
  return light;
  // start: // Your lines here. rows.size() is how many there are.
  // start: return rows[0];
}
// hint: Page 07 looks at directions from straight above. What is a row there?
// hint: A ring of the disk of radius 1. Its share of the disk is what the row's light counts.
// hint: A direction at the angle t from straight up has the distance sin t from the disk's middle.
// hint: Or: the integral of cos t sin t, from a to b, is (sin b sin b - sin a sin a) / 2.
