// What a lesson does for a hook that it does not override.
#include "engine/draw/lesson.hpp"

#include <stdexcept>

#include "texture/surface.hpp"

namespace texmap {

Surface<double> LessonHooks::first_surface(const Ray<double>& /*ray*/) const {
  throw std::logic_error("this lesson does not override first_surface()");
}

}  // namespace texmap
