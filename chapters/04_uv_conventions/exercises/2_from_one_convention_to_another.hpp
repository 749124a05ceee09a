// Exercise 04.2: from one convention to another
//
// In the course's convention (rtiow), u is 0 on -x and 1/4 on +z. In the lecture's, u is 0 on +z
// and grows to the east, too. Return the lecture's u for the course's u. Both are at least 0 and
// less than 1.
//
// Check it:  ./course check 04.2
#include "exercise.hpp"

double lecture_u(double u) {
  // Your lines here.
  return u;
}
