// Exercise 02.2: a walk on the map
//
// An ant is at the point p of a sphere with this center and radius. It walks, and on the sphere's
// map it goes by du to the east and by dv to the north: both are parts of the map's width and
// height, negative to the west and to the south. So du = 1 leads once around, and dv = 1/2 from the
// equator to the north pole. It never walks over a pole. Return the point where it arrives.
#include "exercise.hpp"

Vec3 after_walk(Vec3 p, Vec3 center, double radius, double du, double dv) {
  // solution
  const Vec3 d = (p - center) / radius;
  const double u = 0.5 - std::atan2(d.z, d.x) / (2 * pi) + du;
  const double v = std::acos(std::clamp(-d.y, -1.0, 1.0)) / pi + dv;
  const double from_axis = std::sin(pi * v);
  const Vec3 to{-from_axis * std::cos(2 * pi * u), -std::cos(pi * v),
                from_axis * std::sin(2 * pi * u)};
  return center + to * radius;
  // start: // Your lines here. p - center and p / radius are vectors.
  // start: return {p.x + du, p.y + dv, p.z};
}
// hint: The formulas are for radius 1 around (0, 0, 0): begin with (p - center) / radius.
// hint: Go from there to (u, v), add du and dv, and go back to a direction.
// hint: The direction has length 1. Multiply it by the radius, and add the center.
