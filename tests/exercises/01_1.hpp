// Exercise 01.1: where the ray meets the sphere
//
// The points of a ray are origin + t * direction, t > 0. Return the t of the first point that is
// also on the sphere: |point - center| = radius. Return infinity if there is no such point ahead.
// The direction may have any length; the origin may be inside the sphere.
#include "exercise.hpp"

double distance_to_sphere(Vec3 origin, Vec3 direction, Vec3 center, double radius) {
  // solution
  const Vec3 f = origin - center;
  const double a = dot(direction, direction);
  const double b = -dot(f, direction);
  const double discriminant = b * b - a * (dot(f, f) - radius * radius);
  if (discriminant < 0) return infinity;
  const double entry = (b - std::sqrt(discriminant)) / a;
  const double exit = (b + std::sqrt(discriminant)) / a;
  if (entry > 0) return entry;
  return exit > 0 ? exit : infinity;
  // start: // Your lines here. dot(v, w) is there, and infinity, and all of <cmath>.
  // start: return length(center - origin) - radius;
}
// hint: With f = origin - center, t solves a t * t - 2 b t + c = 0: what are a, b and c?
// hint: b * b - a * c below 0: no point. Otherwise t is (b - root) / a or (b + root) / a.
// hint: The smaller t comes first. But only t > 0 is ahead: from inside it is the larger one.
