// Exercise 07.3: one sample in each ring
//
// A mirror lens has a black disk in its middle. Light comes through the rest of it, the ring from
// the radius `inner` to the radius 1. The lens is cut into n rings of equal area, one around the
// other, and each of its n samples belongs to one of them: sample 0 to the innermost one. Return
// the place of sample i, as Uv{x, y}; the middle of the lens is (0, 0).
// a and b are random, 0 or more and less than 1. a is the share of its ring's area that lies
// farther in than the sample. b gives the angle, 2 pi b, counted from x toward y.
#include "exercise.hpp"

Uv place_on_lens(int i, int n, double a, double b, double inner) {
  // solution
  const double share = (i + a) / n;  // of the whole ring's area, farther in than the sample
  const double radius = std::sqrt(inner * inner + share * (1 - inner * inner));
  return {radius * std::cos(2 * pi * b), radius * std::sin(2 * pi * b)};
  // start: // Your lines here.
  // start: return {a, b};
}
// hint: Which share of the whole ring's area lies farther in than the sample?
// hint: A disk of radius r has the area pi r r. Which area has the ring from `inner` to 1?
// hint: The disk up to the sample is the hole and a share of the ring: how large is its radius?
