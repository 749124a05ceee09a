// Exercise 10.3: back from the cylinder
//
// To make a picture in a layout, a program asks for each texel: which direction is here? (u, v) is
// a place on the unrolled cylinder of the page. Return its point on the unit sphere.
#include "exercise.hpp"

Vec3 direction_of(Uv uv) {
  // solution
  const double angle = (0.5 - uv.u) * 2 * pi;
  const double y = 2 * uv.v - 1;
  const double radius = std::sqrt(1 - y * y);  // of the circle at this height
  return {radius * std::cos(angle), y, radius * std::sin(angle)};
  // start: // Your lines here. Solve the cylinder's two formulas for the angle and for y.
  // start: return {1, uv.v, uv.u};
}
// hint: From u = 1/2 - angle / 2 pi follows angle = (1/2 - u) 2 pi. std::cos wants radians.
// hint: The height is y = 2 v - 1. The circle at this height has the radius sqrt(1 - y^2).
// hint: x is the radius times the cosine, z the radius times the sine.
