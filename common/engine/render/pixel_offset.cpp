// The positions of samples in a pixel.
#include "engine/render/render.hpp"

namespace texmap {

PixelOffset pixel_offset(int sample) {
  // 1/g and 1/g^2 with g = 1.3247..., g^3 = g + 1.
  constexpr double step_x = 0.75487766624669276;
  constexpr double step_y = 0.56984029099805327;
  const double x = 0.5 + sample * step_x;
  const double y = 0.5 + sample * step_y;
  return {x - std::floor(x) - 0.5, y - std::floor(y) - 0.5};
}

}  // namespace texmap
