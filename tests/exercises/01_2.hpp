// Exercise 01.2: how straight the light falls
//
// point is on a surface; normal points away from the surface there, and its length is 1. lamp is
// the lamp's position. Return the cosine of the angle between the normal and the direction to the
// lamp, and 0 if the lamp is behind the surface.
#include "exercise.hpp"

double cosine_of(Vec3 point, Vec3 normal, Vec3 lamp) {
  // solution
  return std::max(dot(normal, normalize(lamp - point)), 0.0);
  // start: // Your line here. dot(v, w), normalize(v) and std::max(x, y) are there.
  // start: // std::max needs two numbers of one type: write 0.0, because 0 is an int.
  // start: return 0.5;
}
// hint: The dot product of two vectors of length 1 is the cosine of the angle between them.
// hint: lamp - point goes from the point to the lamp. normalize(...) gives it the length 1.
// hint: Behind the surface the cosine is negative. std::max(cosine, 0.0) cuts that off.
