// Exercise 04.3: is it mirrored?
//
// here is the place in the picture of a point of the globe: u to the right, v upward. east and
// north are the places of two points next to it, a small step to the east and a small step to the
// north. Return true if letters in the picture are mirrored on the globe. A picture that is only
// turned is not mirrored. To draw the globe, the program takes 1 - u in place of u where you return
// true: if your function is right, all letters on the globe can be read.
#include "exercise.hpp"

bool is_mirrored(Uv here, Uv east, Uv north) {
  // solution
  const double u_e = east.u - here.u, v_e = east.v - here.v;
  const double u_n = north.u - here.u, v_n = north.v - here.v;
  return u_e * v_n - u_n * v_e < 0;
  // start: // Your lines here.
  // start: return false;
}
// hint: How do u and v change with the step to the east, and how with the step to the north?
// hint: East to the right (+), north up (+): letters are as printed. Multiply the two signs.
// hint: For turned pictures take the whole determinant: u_e * v_n - u_n * v_e. What is its sign?
