// Exercise 04.2: from one convention to another
//
// In the course's convention (rtiow), u is 0 on -x and 1/4 on +z. In the lecture's, u is 0 on +z
// and grows to the east, too. Return the lecture's u for the course's u. Both are at least 0 and
// less than 1.
#include "exercise.hpp"

double lecture_u(double u) {
  // solution
  return u < 0.25 ? u + 0.75 : u - 0.25;
  // start: // Your lines here.
  // start: return u;
}
// hint: The point +z has the course's u = 1/4 and the lecture's u = 0.
// hint: u - 0.25 is less than 0 for the first quarter. A whole turn more is the same meridian.
