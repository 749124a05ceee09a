// Exercise 01.2: light on thin paper
//
// The balls are of thin paper. The side that faces the lamp gets the cosine of the angle between
// its normal and the direction to the lamp. The other side gets the given share, 0 to 1, of the
// light that falls on the paper from behind. Slanted light counts less there, too.
// point is on the paper; normal points away from it there, and its length is 1. lamp is the lamp's
// position. Return the light that the side with this normal gets.
#include "exercise.hpp"

double light_on_paper(Vec3 point, Vec3 normal, Vec3 lamp, double share) {
  // solution
  const double cosine = dot(normal, normalize(lamp - point));
  return cosine > 0 ? cosine : share * -cosine;
  // start: // Your lines here. dot(v, w) and normalize(v) are there.
  // start: return share;
}
// hint: The dot product of two vectors of length 1 is the cosine of the angle between them.
// hint: lamp - point goes from the point to the lamp. normalize(...) gives it the length 1.
// hint: If the cosine is negative, the lamp is behind: what is the cosine for the normal -normal?
