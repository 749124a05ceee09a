// Exercise 01.1: where the ray meets the sphere
//
// The upper part of the sphere is cut away. A bowl is left: its points have y <= rim. The points of
// a ray are origin + t * direction, t > 0. Return the t of the first one that is on the bowl, from
// outside or from inside, and infinity if there is none ahead. The direction may have any length.
#include "exercise.hpp"

double distance_to_bowl(Vec3 origin, Vec3 direction, Vec3 center, double radius, double rim) {
  // solution
  const Vec3 f = origin - center;
  const double a = dot(direction, direction);
  const double b = -dot(f, direction);
  const double discriminant = b * b - a * (dot(f, f) - radius * radius);
  if (discriminant < 0) return infinity;
  const double root = std::sqrt(discriminant);
  for (const double t : {(b - root) / a, (b + root) / a}) {
    if (t > 0 && origin.y + t * direction.y <= rim) return t;
  }
  return infinity;
  // start: // Your lines here. dot(v, w) is there, and infinity, and all of <cmath>.
  // start: return length(center - origin) - radius;
}
// hint: Begin with a whole sphere: where does the line meet it? The page has the formula.
// hint: The smaller t comes first. It counts if it is ahead and its point is not above the rim.
// hint: Otherwise the larger t may count: the ray goes in through the open top, or starts inside.
