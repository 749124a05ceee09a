// Which form a scene's spheres need.
#pragma once
#include "scene/shapes.hpp"
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

/// Calls use(sphere) if a shape is one.
template <class Shape, class Use>
void if_sphere(Shape& shape, const Use& use) {
  if constexpr (requires { shape.form; }) use(shape);
}
template <class... Shapes, class Use>
void if_sphere(AnyShape<Shapes...>& any, const Use& use) {
  std::visit([&](auto& shape) { if_sphere(shape, use); },
             static_cast<std::variant<Shapes...>&>(any));
}

/// Gives hybrid to the spheres for which robust does not hold.
///
/// @param objects  each with a `shape`; rays start at the eye and on all spheres
template <class Objects>
void keep_to_domains(Objects& objects, const Point& eye, int digits) {
  for (auto& object : objects) {
    if_sphere(object.shape, [&](Sphere<>& sphere) {
      double distance = length(eye - sphere.center);
      for (auto& other : objects) {
        if_sphere(other.shape, [&](const Sphere<>& from) {
          distance = max(distance, length(from.center - sphere.center) + from.radius);
        });
      }
      if (sphere.form == SphereForm::robust && !robust_form_holds(sphere, distance, digits))
        sphere.form = SphereForm::hybrid;
    });
  }
}

}  // namespace texmap
