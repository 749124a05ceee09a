// Exercise 12.3: draw one of many
//
// sums[i] is the sum of the probabilities of things 0 to i; the last sum is 1, or a rounding below
// it. r is a random number, at least 0 and less than 1. Return the thing that r draws: the first i
// with r < sums[i]. If rounding left no such i, return the last one.
// Example: probabilities 0.5, 0, 0.5 have the sums 0.5, 0.5, 1. Thing 1 is never drawn.
#include "exercise.hpp"

int drawn_thing(const std::vector<double>& sums, double r) {
  // solution
  const int last = static_cast<int>(sums.size()) - 1;
  int i = 0;
  while (i < last && r >= sums[i]) i = i + 1;
  return i;
  // start: // Your lines here. sums.size() is how many there are.
  // start: return static_cast<int>(r * static_cast<double>(sums.size()));
}
// hint: Begin with i = 0, and go on while r is not below sums[i].
// hint: Stop at the last thing, also if r is not below its sum.
