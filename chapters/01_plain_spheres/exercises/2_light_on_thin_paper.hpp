// Exercise 01.2: light on thin paper
//
// The balls are of thin paper. The side that faces the lamp gets the cosine of the angle between
// its normal and the direction to the lamp. The other side gets the given share, 0 to 1, of the
// light that falls on the paper from behind. Slanted light counts less there, too.
// point is on the paper; normal points away from it there, and its length is 1. lamp is the lamp's
// position. Return the light that the side with this normal gets.
//
// Check it:  ./course check 01.2
#include "exercise.hpp"

double light_on_paper(Vec3 point, Vec3 normal, Vec3 lamp, double share) {
  // Your lines here. dot(v, w) and normalize(v) are there.
  return share;
}
