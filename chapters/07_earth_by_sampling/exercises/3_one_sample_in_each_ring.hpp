// Exercise 07.3: one sample in each ring
//
// A mirror lens has a black disk in its middle. Light comes through the rest of it, the ring from
// the radius `inner` to the radius 1. The lens is cut into n rings of equal area, one around the
// other, and each of its n samples belongs to one of them: sample 0 to the innermost one. Return
// the place of sample i, as Uv{x, y}; the middle of the lens is (0, 0).
// a and b are random, 0 or more and less than 1. a is the share of its ring's area that lies
// farther in than the sample. b gives the angle, 2 pi b, counted from x toward y.
//
// Check it:  ./course check 07.3
#include "exercise.hpp"

Uv place_on_lens(int i, int n, double a, double b, double inner) {
  // Your lines here.
  return {a, b};
}
