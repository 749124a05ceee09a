// Exercise 04.3: is it mirrored?
//
// a, b and c are three points of a globe as you see them: x to the right, y upward; z does not
// count. uv_a, uv_b and uv_c are their texture coordinates. On the printed picture u grows to the
// right; v grows upward if v_upward is true, otherwise downward. Return true if its letters are
// mirrored on the globe. Letters that are only turned or slanted are not mirrored. To draw the
// globe, the program takes 1 - u in place of u where you return true.
//
// Check it:  ./course check 04.3
#include "exercise.hpp"

bool is_mirrored(Vec3 a, Vec3 b, Vec3 c, Uv uv_a, Uv uv_b, Uv uv_c, bool v_upward) {
  // Your lines here.
  return false;
}
