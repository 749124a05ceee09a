// Exercise 12.1: the sky in a mirror ball
//
// A camera photographs a mirror ball from so far away that all of its rays run along -z. The ball's
// outline touches the four sides of the picture. u is 0 at the left side and 1 at the right one,
// v is 0 at the lower side and 1 at the upper one; +x is to the right and +y is up. Return the
// direction of the sky that is seen at (u, v), of length 1. The place is inside the outline.
#include "exercise.hpp"

Vec3 mirrored_sky(Uv uv) {
  // solution
  const double x = 2 * uv.u - 1;
  const double y = 2 * uv.v - 1;
  const Vec3 n{x, y, std::sqrt(1 - x * x - y * y)};
  const Vec3 e{0, 0, 1};  // back to the camera
  return 2 * dot(n, e) * n - e;
  // start: // Your lines here.
  // start: return normalize(Vec3{uv.u, uv.v, 1});
}
// hint: Which point of the ball, with the radius 1, is seen at (u, v)? Its normal is that point.
// hint: x and y are -1 to 1 in the picture, and x x + y y + z z = 1.
// hint: Each ray comes along -z, so e, the direction back to the camera, is (0, 0, 1).
