// Exercise 04.3: is it mirrored?
//
// a, b and c are three points of a globe as you see them: x to the right, y upward; z does not
// count. uv_a, uv_b and uv_c are their texture coordinates. On the printed picture u grows to the
// right; v grows upward if v_upward is true, otherwise downward. Return true if its letters are
// mirrored on the globe. Letters that are only turned or slanted are not mirrored. To draw the
// globe, the program takes 1 - u in place of u where you return true.
#include "exercise.hpp"

bool is_mirrored(Vec3 a, Vec3 b, Vec3 c, Uv uv_a, Uv uv_b, Uv uv_c, bool v_upward) {
  // solution
  const double seen = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  const double in_uv =
      (uv_b.u - uv_a.u) * (uv_c.v - uv_a.v) - (uv_c.u - uv_a.u) * (uv_b.v - uv_a.v);
  const double printed = v_upward ? in_uv : -in_uv;
  return seen * printed < 0;
  // start: // Your lines here.
  // start: return false;
}
// hint: On the way from a to b, is c to the left? Ask it of what you see, and of the print.
// hint: The letters are mirrored if the two answers differ.
// hint: The page's determinant is positive if the second step is counterclockwise from the first.
