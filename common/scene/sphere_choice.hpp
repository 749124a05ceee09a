// Which form a scene's spheres need.
#pragma once
#include "scene/sphere.hpp"

namespace texmap {

/// True within the domain of the robust form.
///
/// @param distance  from the center to the farthest origin of a ray
/// @param digits    of the number that draws, in base 2: float has 24
[[nodiscard]] inline bool robust_form_holds(const Sphere<>& sphere, double distance, int digits) {
  const bool is_float = digits <= std::numeric_limits<float>::digits;
  const double radii = is_float ? 1e4 : 1e7;
  const double longest = is_float ? 1e9 : 1e76;  // its fourth power is in range
  return distance <= radii * sphere.radius && distance + sphere.radius < longest &&
         sphere.radius > 1 / longest;
}

/// Gives hybrid to the spheres for which robust does not hold.
///
/// @param objects  each with a `shape`; rays start at the eye and on all of them
template <class Objects>
void keep_to_domains(Objects& objects, const Point& eye, int digits) {
  for (auto& object : objects) {
    Sphere<>& sphere = object.shape;
    double distance = length(eye - sphere.center);
    for (const auto& other : objects)
      distance = max(distance, length(other.shape.center - sphere.center) + other.shape.radius);
    if (sphere.form == SphereForm::robust && !robust_form_holds(sphere, distance, digits))
      sphere.form = SphereForm::hybrid;
  }
}

}  // namespace texmap
