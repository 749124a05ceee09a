// Exercise 12.3: more directions to the sky
//
// At each point of a matte surface a program draws m directions by the cosine and k directions by
// the sky's light. It adds up the sky's light in all of them, each times a weight, and multiplies
// the sum by the albedo. Return the weight of a direction, whichever way drew it. `cosine` is n . d
// for this direction, and q is the density by which the sky's way draws it.
#include "exercise.hpp"

double weight_of(double cosine, double q, int m, int k) {
  // solution
  if (cosine <= 0) return 0;
  return cosine / (m * cosine + k * pi * q);
  // start: // Your lines here.
  // start: return 1.0 / (m + k);
}
// hint: How many directions of both ways together are there in a small solid angle around d?
// hint: The first way has the density cosine / pi. What is the sum for m = 1 and k = 1?
// hint: Below the surface the cosine is below 0, and no light comes from there.
